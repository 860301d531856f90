#include "core/crossings/contacts/passages.h"

#include <algorithm>

namespace kriva {
namespace {

constexpr int kMostHalvings = 60;

bool isNear(const Arc& arc, Point place, double gap) {
    if (!overlap(grown(arc.box, gap), Box{place.x, place.y, place.x, place.y}))
        return false;
    const Vector chord = arc.chord();
    const double scaled = gap * std::sqrt(dot(chord, chord));
    double low = 0, high = 0;
    for (const Point p : arc.polygon()) {
        const double aside = cross(chord, p - arc.front());
        low = std::min(low, aside);
        high = std::max(high, aside);
    }
    const double aside = cross(chord, place - arc.front());
    return aside >= low - scaled && aside <= high + scaled;
}

struct Stretch {
    double from;
    double to;
};

void collect(const Arc& arc, Point place, double gap, int depth, std::vector<Stretch>& found) {
    if (!isNear(arc, place, gap))
        return;
    if (arc.size() <= gap || depth == kMostHalvings) {
        if (!found.empty() && found.back().to >= arc.from)
            found.back().to = arc.to;
        else
            found.push_back({arc.from, arc.to});
        return;
    }
    const auto [left, right] = halved(arc);
    collect(left, place, gap, depth + 1, found);
    collect(right, place, gap, depth + 1, found);
}

} // namespace

double foot(const Arc& arc, Point place, double t) {
    for (int step = 0; step < 8; ++step) {
        const ArcPoint there = evaluate(arc, t);
        const double squared = dot(there.velocity, there.velocity);
        if (squared == 0)
            break;
        t = std::clamp(t + dot(place - there.at, there.velocity) / squared, 0.0, 1.0);
    }
    return t;
}

std::vector<double> passagesThrough(const Arc& arc, Point place, double gap) {
    std::vector<Stretch> stretches;
    collect(arc, place, gap, 0, stretches);
    std::vector<double> found;
    const double whole = arc.to - arc.from;
    for (const auto [from, to] : stretches) {
        const auto away = [&](double t) { return distance(evaluate(arc, t).at, place); };
        double best = (from / 2 + to / 2 - arc.from) / whole;
        for (const double t : {foot(arc, place, best), (from - arc.from) / whole, (to - arc.from) / whole})
            if (away(t) < away(best))
                best = t;
        if (away(best) <= gap)
            found.push_back(arc.parameter(best));
    }
    return found;
}

} // namespace kriva
