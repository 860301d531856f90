#include "core/intersections/contacts/common_parts.h"

#include "core/intersections/contacts/passages.h"

#include <algorithm>

namespace kriva {
namespace {

/// Whether the segments lie on each other between two contacts: at more places than different curves can meet in, in
/// the same order on both.
bool lieTogether(const Arc& a, const Arc& b, Contact from, Contact to, double touching, WorkBudget& budget) {
    const std::size_t samples = a.degree * b.degree + 1;
    double reached = from.b;
    for (std::size_t i = 1; i <= samples; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(samples + 1);
        const Point place = evaluate(a, std::lerp(from.a, to.a, share)).at;
        const auto isOnTheWay = [&](double t) {
            return from.b < to.b ? t > reached && t < to.b : t < reached && t > to.b;
        };
        const std::vector<double> passages = passagesThrough(b, place, touching, budget);
        const auto next = std::ranges::find_if(passages, isOnTheWay);
        if (next == passages.end())
            return false;
        reached = *next;
    }
    return true;
}

/// Whether a parameter lies between two others, or the arc stays within a place from one of these to it.
bool isOnStretch(const Arc& arc, double from, double to, double t, double place) {
    const auto [low, high] = std::minmax(from, to);
    if (t >= low && t <= high)
        return true;
    const double end = t < low ? low : high;
    return part(arc, std::min(t, end), std::max(t, end)).size() <= place;
}

/// Continues the last part found if the stretch starts where that ended. Where an end is told twice, a rounding apart,
/// so is what starts there: a stretch of a known part is left out.
void append(std::vector<CommonPart>& parts, const CommonPart& stretch, const Arc& a, const Arc& b, double place) {
    for (CommonPart& known : parts) {
        if ((known.from.b < known.to.b) != (stretch.from.b < stretch.to.b))
            continue;
        if (known.to == stretch.from) {
            known.to = stretch.to;
            return;
        }
        const auto isOnKnown = [&](const Contact& end) {
            return isOnStretch(a, known.from.a, known.to.a, end.a, place) &&
                   isOnStretch(b, known.from.b, known.to.b, end.b, place);
        };
        if (isOnKnown(stretch.from) && isOnKnown(stretch.to))
            return;
    }
    parts.push_back(stretch);
}

} // namespace

std::vector<CommonPart> commonParts(const Arc& a, const Arc& b, std::vector<Contact> contacts,
                                    const ContactScale& scale, WorkBudget& budget) {
    std::ranges::sort(contacts, {}, [](const Contact& contact) { return std::pair(contact.a, contact.b); });
    std::vector<CommonPart> parts;
    for (std::size_t i = 0; i < contacts.size(); ++i)
        for (std::size_t j = i + 1; j < contacts.size(); ++j) {
            const CommonPart stretch{contacts[i], contacts[j]};
            const auto& [from, to] = stretch;
            if (!(from.a < to.a) || from.b == to.b)
                continue;
            if (part(a, from.a, to.a).size() <= scale.place || !lieTogether(a, b, from, to, scale.touching, budget))
                continue;
            append(parts, stretch, a, b, scale.place);
            break;
        }
    return parts;
}

} // namespace kriva
