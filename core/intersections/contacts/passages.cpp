#include "core/intersections/contacts/passages.h"

#include <algorithm>
#include <cmath>

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

void collect(const Arc& arc, Point place, double gap, int depth, WorkBudget& budget, std::vector<Stretch>& found) {
    if (!budget.spend() || !isNear(arc, place, gap))
        return;
    if (arc.size() <= gap || depth == kMostHalvings) {
        if (!found.empty() && found.back().to >= arc.from)
            found.back().to = arc.to;
        else
            found.push_back({arc.from, arc.to});
        return;
    }
    const auto [left, right] = halved(arc);
    collect(left, place, gap, depth + 1, budget, found);
    collect(right, place, gap, depth + 1, budget, found);
}

/// Whether a place of one segment lies on the other between two of its parameters.
bool isOnBetween(const Arc& arc, double from, double to, Point place, double touching, WorkBudget& budget) {
    const auto isBetween = [low = std::min(from, to), high = std::max(from, to)](double t) {
        return t >= low - kAtEnd && t <= high + kAtEnd;
    };
    return std::ranges::any_of(passagesThrough(arc, place, touching, budget), isBetween);
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

std::vector<double> passagesThrough(const Arc& arc, Point place, double gap, WorkBudget& budget) {
    std::vector<Stretch> stretches;
    collect(arc, place, gap, 0, budget, stretches);
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

bool touchBetween(const Arc& a, const Arc& b, Contact one, Contact other, double touching, WorkBudget& budget) {
    return std::ranges::all_of(std::array{0.5, 0.25, 0.75}, [&](double share) {
        const Point onA = evaluate(a, std::lerp(one.a, other.a, share)).at;
        const Point onB = evaluate(b, std::lerp(one.b, other.b, share)).at;
        return isOnBetween(b, one.b, other.b, onA, touching, budget) &&
               isOnBetween(a, one.a, other.a, onB, touching, budget);
    });
}

} // namespace kriva
