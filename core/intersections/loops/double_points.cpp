#include "core/intersections/loops/double_points.h"

#include "core/intersections/contacts/passages.h"
#include "core/intersections/loops/loop_quotient.h"

#include <algorithm>
#include <cmath>

namespace kriva {
namespace {

/// Below this v a loop is smaller than what counts as touching: a cusp, seen through rounding.
constexpr double kLeastLoop = 1e-13;

/// Halvings after which a rectangle is as small as a multiple root can be seen.
constexpr int kDeepest = 56;

/// Rectangles looked at before a segment counts as lying on itself within rounding.
constexpr int kMostCells = 200'000;

/// The quotient in a rectangle, moved there and bounded.
constexpr std::uint64_t kStepsOfCell = 32;

/// Roots may lie outside of the segment by rounding.
constexpr double kSlack = 1e-9;

/// A rectangle of u and v.
struct Cell {
    double u0, u1, v0, v1;
    [[nodiscard]] LoopPlace centre() const { return {u0 / 2 + u1 / 2, v0 / 2 + v1 / 2}; }
};

/// Finds all roots of a quotient with m - h >= 0, m + h <= 1.
class RootSearch {
  public:
    RootSearch(const LoopQuotient& quotient, WorkBudget& budget)
        : quotient_(quotient)
        , budget_(budget) {}

    std::vector<LoopPlace> roots() {
        visit({-0.5, 0.5, 0, 0.25}, 0);
        return std::move(found_);
    }

  private:
    void visit(const Cell& cell, int depth) {
        if (++cells_ > kMostCells || !budget_.spend(kStepsOfCell))
            return;
        // The nearest u to the middle leaves most room for h.
        const double nearest = cell.u0 > 0 ? cell.u0 : cell.u1 < 0 ? -cell.u1 : 0;
        if (std::sqrt(cell.v0) > 0.5 - nearest + kSlack)
            return;
        const LoopPlace centre = cell.centre();
        const LoopValue local = evaluate(quotient_, centre);
        const LocalQuotient near = around(quotient_, centre, (cell.u1 - cell.u0) / 2, (cell.v1 - cell.v0) / 2);
        // Beside the coordinates, what is left where a derivative does not reach: near a place where the curve touches
        // itself both derivatives have one direction.
        for (const Vector along : {Vector{1, 0}, Vector{0, 1}, local.byU, local.byV})
            if (hasNoRoot(near, {-along.y, along.x}))
                return;
        if (decide(cell, local, near))
            return;
        if (depth == kDeepest) {
            addTouching(centre, 64 * (cell.u1 - cell.u0));
            return;
        }
        const double middle = depth % 2 == 0 ? centre.u : centre.v;
        if (depth % 2 == 0) {
            visit({cell.u0, middle, cell.v0, cell.v1}, depth + 1);
            visit({middle, cell.u1, cell.v0, cell.v1}, depth + 1);
        } else {
            visit({cell.u0, cell.u1, cell.v0, middle}, depth + 1);
            visit({cell.u0, cell.u1, middle, cell.v1}, depth + 1);
        }
    }

    /// Whether all roots in the cell are known. With the derivatives multiplied by the inverse of those in the centre,
    /// there is one root at most where they differ from the identity by less than 1 in each row.
    bool decide(const Cell& cell, const LoopValue& local, const LocalQuotient& near) {
        const double turn = cross(local.byU, local.byV);
        const auto row = [&](Vector by) { // of the inverse, times a derivative's deviation
            const double first = (std::abs(local.byV.y) * by.x + std::abs(local.byV.x) * by.y) / std::abs(turn);
            const double second = (std::abs(local.byU.y) * by.x + std::abs(local.byU.x) * by.y) / std::abs(turn);
            return Vector{first, second};
        };
        const Vector byU = row(deviationByU(near)), byV = row(deviationByV(near));
        if (turn == 0 || byU.x + byV.x >= 1 || byU.y + byV.y >= 1)
            return false;
        LoopPlace place = cell.centre();
        for (int step = 0; step < 40; ++step) {
            const LoopValue here = evaluate(quotient_, place);
            const double det = cross(here.byU, here.byV);
            if (det == 0)
                return false;
            const double du = -cross(here.value, here.byV) / det, dv = -cross(here.byU, here.value) / det;
            place = {place.u + du, place.v + dv};
            if (std::abs(place.u) > 2 || std::abs(place.v) > 2)
                return false;
            if (std::abs(du) + std::abs(dv) > 1e-15)
                continue;
            break;
        }
        const double slackU = (cell.u1 - cell.u0) * 1e-6, slackV = (cell.v1 - cell.v0) * 1e-6;
        if (place.u < cell.u0 - slackU || place.u > cell.u1 + slackU || place.v < cell.v0 - slackV ||
            place.v > cell.v1 + slackV)
            return false;
        found_.push_back(place);
        return true;
    }

    /// Cells too small to halve, around a place where the curve touches itself: both derivatives have one direction
    /// there, along which Newton's method still works.
    void addTouching(LoopPlace place, double near) {
        for (int step = 0; step < 3; ++step) {
            const LoopValue here = evaluate(quotient_, place);
            const Vector along = dot(here.byU, here.byU) > dot(here.byV, here.byV) ? here.byU : here.byV;
            const double u = dot(along, here.byU), v = dot(along, here.byV);
            const double squared = u * u + v * v;
            if (squared == 0)
                break;
            const double way = -dot(along, here.value) / squared;
            place = {place.u + way * u, place.v + way * v};
        }
        const auto isSame = [&](const LoopPlace& other) {
            return std::abs(other.u - place.u) <= near && std::abs(other.v - place.v) <= near;
        };
        if (std::ranges::none_of(found_, isSame))
            found_.push_back(place);
    }

    const LoopQuotient& quotient_;
    WorkBudget& budget_;
    std::vector<LoopPlace> found_;
    int cells_ = 0;
};

/// The quotient of a cubic is a (3 u^2 + v) + b u + c, of which the cross products with a and b leave u and v.
std::vector<LoopPlace> rootsOfCubic(const LoopQuotient& quotient) {
    const Vector a = quotient.terms[0][1], b = quotient.terms[1][0], c = quotient.terms[0][0];
    const double turn = cross(a, b);
    if (turn == 0)
        return {};
    const double u = -cross(a, c) / turn;
    return {{u, cross(b, c) / turn - 3 * u * u}};
}

/// A parabola traced forth and back around its middle m: all odd powers of t - m vanish.
std::optional<double> middleOfRetrace(const LoopQuotient& quotient) {
    const Vector fourth = quotient.terms[3][0]; // 4 times the coefficient of the fourth power
    if (fourth == Vector{} || length(quotient.terms[4][0]) > 1e-12 * length(fourth))
        return {};
    const Vector third = quotient.terms[2][0];
    const double u = -dot(third, fourth) / (3 * dot(fourth, fourth));
    double size = 0;
    for (const auto& row : quotient.terms)
        for (const Vector& c : row)
            size = std::max({size, std::abs(c.x), std::abs(c.y)});
    for (const double v : {0.0, 0.125, 0.25}) {
        const Vector value = evaluate(quotient, {u, v}).value;
        if (length(value) > 1e-12 * size)
            return {};
    }
    if (std::abs(u) >= 0.5)
        return {};
    return u + 0.5;
}

} // namespace

SegmentContacts doublePoints(const Arc& arc, const ContactScale& scale, WorkBudget& budget) {
    SegmentContacts result;
    if (arc.degree < 3)
        return result;
    const LoopQuotient quotient = loopQuotientOf(arc);
    if (const auto middle = middleOfRetrace(quotient)) {
        const double half = std::min(*middle, 1 - *middle);
        // The first pass forth, the second one back from the same place.
        result.common.push_back({{*middle - half, *middle + half}, {*middle, *middle}});
        return result;
    }
    if (distance(arc.front(), arc.back()) <= scale.touching)
        result.contacts.push_back({0, 1});
    for (const LoopPlace place : arc.degree == 3 ? rootsOfCubic(quotient) : RootSearch(quotient, budget).roots()) {
        if (!(place.v > kLeastLoop))
            continue;
        const double h = std::sqrt(place.v);
        if (!(h <= 0.5 - std::abs(place.u) + kSlack))
            continue;
        const Contact contact{std::clamp(0.5 + place.u - h, 0.0, 1.0), std::clamp(0.5 + place.u + h, 0.0, 1.0)};
        if (distance(evaluate(arc, contact.a).at, evaluate(arc, contact.b).at) > scale.touching)
            continue;
        // Where the segment touches itself, roots are found all along.
        const auto isSame = [&](const Contact& other) {
            return touchBetween(arc, arc, contact, other, scale.touching, budget);
        };
        if (std::ranges::none_of(result.contacts, isSame))
            result.contacts.push_back(contact);
    }
    return result;
}

} // namespace kriva
