#include "core/intersections/contacts/segment_contacts.h"

#include "core/bezier/evaluate.h"
#include "core/bezier/measures/curvature.h"
#include "core/intersections/contacts/common_parts.h"
#include "core/intersections/contacts/contact_search.h"
#include "core/intersections/contacts/flattest_contact.h"
#include "core/intersections/contacts/passages.h"
#include "core/polynomial/bernstein_polynomial.h"
#include "core/polynomial/hodograph_forms.h"
#include "core/polynomial/sign_changes.h"

#include <algorithm>

namespace kriva {
namespace {

/// A speed this part of the control polygon's length is none.
constexpr double kNoSpeed = 1e-9;

/// Two segments whose boxes overlap, before anything is halved.
constexpr std::uint64_t kStepsOfPair = 40;

std::vector<double> cuspsOf(std::span<const Point> segment, const Arc& arc) {
    if (tangentCone(arc))
        return {};
    // Where the speed is least, its square turns from falling to rising.
    const double unit = unitOf(segment);
    const auto hodograph = hodographIn<double>(unit, segment);
    const std::vector<double> least = signChanges(differentiated(speedSquared(hodograph)));
    std::vector<double> cusps;
    for (const double t : least)
        if (length(derivative(segment, t)) <= kNoSpeed * polygonLength(segment))
            cusps.push_back(t);
    return cusps;
}

/// The ends of the segment and its cusps, ascending.
std::vector<double> breaksOf(const CuspedArc& segment) {
    std::vector<double> breaks{0};
    breaks.insert(breaks.end(), segment.cusps.begin(), segment.cusps.end());
    breaks.push_back(1);
    return breaks;
}

/// Whether a segment stays within the size between two of its parameters.
bool stays(const Arc& arc, double t, double s, double size) {
    return t == s || part(arc, std::min(t, s), std::max(t, s)).size() <= size;
}

/// Where a break of a lies on b. At a break of b, where that may nearly stand still, no other parameter tells the
/// place.
std::vector<Contact> breaksOn(const CuspedArc& a, const CuspedArc& b, double touching, WorkBudget& budget) {
    std::vector<Contact> found;
    for (const double t : breaksOf(a)) {
        const Point place = t == 0 ? a.arc.front() : t == 1 ? a.arc.back() : evaluate(a.arc, t).at;
        for (const double s : passagesThrough(b.arc, place, touching, budget)) {
            Contact contact{t, s};
            for (const double end : breaksOf(b))
                if (std::abs(s - end) <= kAtEnd || stays(b.arc, s, end, touching))
                    contact.b = end;
            found.push_back(contact);
        }
    }
    return found;
}

void appendNew(std::vector<Contact>& all, const Contact& contact) {
    if (std::ranges::find(all, contact) == all.end())
        all.push_back(contact);
}

/// Whether both segments stay within a place between two contacts.
bool areOnePlace(const CuspedArc& a, const CuspedArc& b, Contact one, Contact other, double place) {
    return stays(a.arc, one.a, other.a, place) && stays(b.arc, one.b, other.b, place);
}

/// The contacts in order along a, those between which the segments touch throughout as one, where they are flattest.
std::vector<Contact> united(const CuspedArc& a, const CuspedArc& b, std::vector<Contact> contacts, double touching,
                            WorkBudget& budget) {
    std::ranges::sort(contacts, {}, &Contact::a);
    std::vector<Contact> all;
    for (std::size_t first = 0, last = 0; first < contacts.size(); first = last) {
        last = first + 1;
        while (last < contacts.size() &&
               touchBetween(a.arc, b.arc, contacts[last - 1], contacts[last], touching, budget))
            ++last;
        const double way = contacts[last - 1].a - contacts[first].a;
        if (!budget.spend(way == 0 ? 1 : kStepsOfTouching))
            break;
        all.push_back(way == 0 ? contacts[first] : flattestContact(a.arc, b.arc, contacts[first], kReach * way));
    }
    return all;
}

/// The segment between the breaks, as arcs with parameters of the segment.
std::vector<Arc> cutAt(const Arc& arc, std::vector<double> breaks) {
    std::ranges::sort(breaks);
    const auto repeated = std::ranges::unique(breaks);
    breaks.erase(repeated.begin(), repeated.end());
    std::vector<Arc> arcs;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        arcs.push_back(part(arc, breaks[i], breaks[i + 1]));
    return arcs;
}

bool isInside(const Arc& arc, double from, double to) {
    return arc.from >= std::min(from, to) && arc.to <= std::max(from, to);
}

/// Two segments while their contacts are sought.
struct Pair {
    const CuspedArc& a;
    const CuspedArc& b;
    const ContactScale& scale;
    WorkBudget& budget;

    /// Where a break of either lies on the other, after the joints.
    [[nodiscard]] std::vector<Contact> contactsAtBreaks(std::span<const Contact> joints) const {
        std::vector<Contact> contacts(joints.begin(), joints.end());
        for (const Contact& contact : breaksOn(a, b, scale.touching, budget))
            appendNew(contacts, contact);
        for (const Contact& contact : breaksOn(b, a, scale.touching, budget))
            appendNew(contacts, {contact.b, contact.a});
        return contacts;
    }

    /// All contacts but those at breaks, outside of the common parts; `known` are joints and ends of common parts.
    [[nodiscard]] std::vector<Contact> contactsBetweenBreaks(std::span<const CommonPart> common,
                                                             std::span<const Contact> known) const {
        std::vector<double> breaksA = breaksOf(a), breaksB = breaksOf(b);
        for (const auto& [from, to] : common) {
            breaksA.insert(breaksA.end(), {from.a, to.a});
            breaksB.insert(breaksB.end(), {from.b, to.b});
        }
        const std::vector<Arc> others = cutAt(b.arc, std::move(breaksB));
        std::vector<Contact> found;
        ContactSearch search(scale, known, budget);
        for (const Arc& one : cutAt(a.arc, std::move(breaksA)))
            for (const Arc& other : others) {
                const auto areIn = [&](const CommonPart& part) {
                    return isInside(one, part.from.a, part.to.a) && isInside(other, part.from.b, part.to.b);
                };
                if (std::ranges::none_of(common, areIn))
                    search.search(one, other, found);
            }
        return united(a, b, std::move(found), scale.touching, budget);
    }

    /// A break that lies on the other segment is a contact itself; one that just comes close gives way to a crossing.
    void addAtBreak(const Contact& contact, std::vector<Contact>& found) const {
        const auto isSame = [&](const Contact& other) {
            return touchBetween(a.arc, b.arc, contact, other, scale.touching, budget);
        };
        if (gapAt(a.arc, b.arc, contact) <= kOn * scale.touching)
            std::erase_if(found, isSame);
        if (std::ranges::none_of(found, isSame))
            found.push_back(contact);
    }

    [[nodiscard]] bool isKnown(const Contact& contact, std::span<const CommonPart> common,
                               std::span<const Contact> known) const {
        const auto isSame = [&](const Contact& other) { return areOnePlace(a, b, contact, other, 4 * scale.place); };
        const auto isOn = [&contact](const CommonPart& part) {
            const auto [low, high] = std::minmax(part.from.b, part.to.b);
            return contact.a >= part.from.a && contact.a <= part.to.a && contact.b >= low && contact.b <= high;
        };
        return std::ranges::any_of(known, isSame) || std::ranges::any_of(common, isOn);
    }
};

} // namespace

CuspedArc cuspedArcOf(std::span<const Point> segment, const ArcFrame& frame) {
    const Arc arc = arcOf(segment, frame);
    return {arc, cuspsOf(segment, arc)};
}

SegmentContacts contactsOf(const CuspedArc& a, const CuspedArc& b, std::span<const Contact> joints,
                           const ContactScale& scale, WorkBudget& budget) {
    if (!budget.spend(kStepsOfPair) || !overlap(grown(a.arc.box, scale.touching), b.arc.box) ||
        areApart(a.arc, b.arc, scale.touching))
        return {};
    const Pair pair{a, b, scale, budget};
    const std::vector<Contact> atBreaks = pair.contactsAtBreaks(joints);
    SegmentContacts result;
    if (atBreaks.size() > 1)
        result.common = commonParts(a.arc, b.arc, atBreaks, scale, budget);
    std::vector<Contact> known(joints.begin(), joints.end());
    for (const auto& [from, to] : result.common)
        known.insert(known.end(), {from, to});
    std::vector<Contact> found = pair.contactsBetweenBreaks(result.common, known);
    for (const Contact& contact : atBreaks)
        pair.addAtBreak(contact, found);
    for (const Contact& contact : found)
        if (budget.spend(kStepsOfPair) && !pair.isKnown(contact, result.common, known))
            result.contacts.push_back(contact);
    return result;
}

} // namespace kriva
