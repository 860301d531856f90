#include "core/crossings/contacts/common_parts.h"

#include "core/crossings/contacts/passages.h"

#include <algorithm>

namespace kriva {
namespace {

/// Whether the segments lie on each other between two contacts: at more places than different curves can meet in, in
/// the same order on both.
bool lieTogether(const Arc& a, const Arc& b, Contact from, Contact to, double touching) {
    const std::size_t samples = a.degree * b.degree + 1;
    double reached = from.b;
    for (std::size_t i = 1; i <= samples; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(samples + 1);
        const Point place = evaluate(a, std::lerp(from.a, to.a, share)).at;
        const auto isOnTheWay = [&](double t) {
            return from.b < to.b ? t > reached && t < to.b : t < reached && t > to.b;
        };
        const std::vector<double> passages = passagesThrough(b, place, touching);
        const auto next = std::ranges::find_if(passages, isOnTheWay);
        if (next == passages.end())
            return false;
        reached = *next;
    }
    return true;
}

/// Continues the last part found if the stretch starts where that ended.
void append(std::vector<CommonPart>& parts, const CommonPart& stretch) {
    for (CommonPart& part : parts)
        if (part.to == stretch.from && (part.from.b < part.to.b) == (stretch.from.b < stretch.to.b)) {
            part.to = stretch.to;
            return;
        }
    parts.push_back(stretch);
}

} // namespace

std::vector<CommonPart> commonParts(const Arc& a, const Arc& b, std::vector<Contact> contacts,
                                    const ContactScale& scale) {
    std::ranges::sort(contacts, {}, [](const Contact& contact) { return std::pair(contact.a, contact.b); });
    std::vector<CommonPart> parts;
    for (std::size_t i = 0; i < contacts.size(); ++i)
        for (std::size_t j = i + 1; j < contacts.size(); ++j) {
            const Contact& from = contacts[i];
            const Contact& to = contacts[j];
            if (!(from.a < to.a) || from.b == to.b)
                continue;
            if (part(a, from.a, to.a).size() <= scale.place || !lieTogether(a, b, from, to, scale.touching))
                continue;
            append(parts, {from, to});
            break;
        }
    return parts;
}

} // namespace kriva
