#include "core/intersections/contacts/contact_search.h"

#include "core/intersections/contacts/flattest_contact.h"
#include "core/intersections/contacts/graph_gap.h"

#include <algorithm>
#include <cmath>

namespace kriva {
namespace {

/// Halvings of both arcs together after which parameters differ by rounding only.
constexpr int kDeepest = 100;

/// Halving, boxes and strips of two arcs.
constexpr std::uint64_t kStepsOfVisit = 12;

/// Arcs that may be a little farther apart than `touching` still count as touching all along: else the places where
/// they are just that far apart would be halved without end.
constexpr double kStillTouching = 1.5;

/// The direction from the place to the first control point that differs, of length 1.
Vector wayFrom(Point place, std::span<const Point> points, bool isAtBack) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector way = points[isAtBack ? points.size() - 1 - i : i] - place;
        if (way != Vector{})
            return way / length(way);
    }
    return {};
}

/// Whether two arcs that are joined at an end of each lie on different sides of a line through the joint.
bool meetOnlyAtJoint(const Arc& a, bool isAtBackOfA, const Arc& b, bool isAtBackOfB) {
    const Point joint = isAtBackOfA ? a.back() : a.front();
    const Point other = isAtBackOfB ? b.back() : b.front();
    const Vector forward = wayFrom(other, b.polygon(), isAtBackOfB) - wayFrom(joint, a.polygon(), isAtBackOfA);
    const auto isBehind = [&](Point p) { return p == joint || dot(forward, p - joint) < 0; };
    const auto isAhead = [&](Point p) { return p == other || dot(forward, p - other) > 0; };
    return std::ranges::all_of(a.polygon(), isBehind) && std::ranges::all_of(b.polygon(), isAhead);
}

bool isWithin(double t, double slack) {
    return t >= -slack && t <= 1 + slack;
}

} // namespace

void ContactSearch::search(const Arc& a, const Arc& b, std::vector<Contact>& found) {
    found_ = &found;
    visit(a, b, 0);
}

void ContactSearch::visit(const Arc& a, const Arc& b, int depth) {
    if (!budget_.spend(kStepsOfVisit))
        return;
    if (!overlap(grown(a.box, scale_.touching), b.box) || areApart(a, b, scale_.touching))
        return;
    bool atJoint = false;
    for (const Contact& joint : joints_) {
        const bool atA = a.from == joint.a || a.to == joint.a;
        const bool atB = b.from == joint.b || b.to == joint.b;
        if (!atA || !atB)
            continue;
        atJoint = true;
        if (meetOnlyAtJoint(a, a.to == joint.a, b, b.to == joint.b))
            return;
    }
    if (decide(a, b, atJoint))
        return;
    if (depth == kDeepest || areWithinTouching(a, b)) {
        addTouching(a, b);
        return;
    }
    if (a.size() >= b.size()) {
        const auto [left, right] = halved(a);
        visit(left, b, depth + 1);
        visit(right, b, depth + 1);
    } else {
        const auto [left, right] = halved(b);
        visit(a, left, depth + 1);
        visit(a, right, depth + 1);
    }
}

/// Whether all contacts of the two arcs are known; they are appended then.
bool ContactSearch::decide(const Arc& a, const Arc& b, bool atJoint) {
    const auto coneA = tangentCone(a);
    const auto coneB = tangentCone(b);
    if (!coneA || !coneB)
        return false;
    if (areTransversal(*coneA, *coneB)) {
        if (atJoint)
            return true;
        const auto contact = crossing(a, b);
        if (contact)
            found_->push_back(*contact);
        return contact.has_value();
    }
    const auto gap = GraphGap::between(a, b, budget_);
    if (!gap)
        return false;
    const auto contacts = gap->contacts(scale_.touching, budget_);
    if (!contacts) {
        if (gap->isWithin(kStillTouching * scale_.touching))
            addTouching(a, b);
        return gap->isWithin(kStillTouching * scale_.touching);
    }
    found_->insert(found_->end(), contacts->begin(), contacts->end());
    return true;
}

/// Newton's method from where the chords meet. Nothing unless it arrives within both arcs.
std::optional<Contact> ContactSearch::crossing(const Arc& a, const Arc& b) const {
    double t = 0.5, s = 0.5;
    for (int step = 0; step < 16; ++step) {
        const ArcPoint p = evaluate(a, t);
        const ArcPoint q = evaluate(b, s);
        const Vector rest = q.at - p.at;
        const double turn = cross(p.velocity, q.velocity);
        if (turn == 0)
            return {};
        const double stepA = cross(rest, q.velocity) / turn;
        const double stepB = cross(rest, p.velocity) / turn;
        t += stepA;
        s += stepB;
        if (!isWithin(t, 1) || !isWithin(s, 1))
            return {};
        if (std::abs(stepA) + std::abs(stepB) > 1e-14)
            continue;
        const double onA = std::clamp(t, 0.0, 1.0), onB = std::clamp(s, 0.0, 1.0);
        if ((onA != t || onB != s) && distance(evaluate(a, onA).at, evaluate(b, onB).at) > scale_.touching * kOn)
            return {};
        return Contact{a.parameter(onA), b.parameter(onB)};
    }
    return {};
}

/// Whether one strip as wide as `touching` holds both.
bool ContactSearch::areWithinTouching(const Arc& a, const Arc& b) const {
    const Arc& longer = a.size() >= b.size() ? a : b;
    if (longer.size() <= scale_.touching)
        return true;
    const double chord = length(longer.chord());
    double low = 0, high = 0;
    for (const Arc* arc : {&a, &b})
        for (const Point p : arc->polygon()) {
            const double aside = cross(longer.chord(), p - longer.front());
            low = std::min(low, aside);
            high = std::max(high, aside);
        }
    return chord >= longer.size() / 2 && high - low <= scale_.touching * chord;
}

/// The place where two arcs that touch all along are flattest against each other. They may also just meet at an end.
void ContactSearch::addTouching(const Arc& a, const Arc& b) {
    if (!budget_.spend(kStepsOfTouching))
        return;
    Contact start{0.5, 0.5};
    for (const Contact& corner : {Contact{0, 0}, Contact{0, 1}, Contact{1, 0}, Contact{1, 1}})
        if (gapAt(a, b, corner) < gapAt(a, b, start))
            start = corner;
    const Contact contact = flattestContact(a, b, start, 1);
    if (gapAt(a, b, contact) <= scale_.touching)
        found_->push_back({a.parameter(contact.a), b.parameter(contact.b)});
}

} // namespace kriva
