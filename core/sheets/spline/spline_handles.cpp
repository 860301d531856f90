#include "core/sheets/spline/editing/chain_edits.h"
#include "core/sheets/spline/editing/joins.h"
#include "core/sheets/spline/spline.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace kriva {
namespace {

using Join = SplineKnot::Join;

constexpr std::size_t kFewestToClose = 3;

/// The direction of the multiple of 15 degrees nearest to a vector's; axes and diagonals bit for bit.
Vector steppedDirection(Vector v) {
    constexpr double pi = std::numbers::pi;
    static const double cos15 = std::cos(pi / 12);
    static const double sin15 = std::sin(pi / 12);
    static const double cos30 = std::cos(pi / 6);
    constexpr double cos45 = std::numbers::sqrt2 / 2;
    const std::array<Vector, 7> quarter{
        {{1, 0}, {cos15, sin15}, {cos30, 0.5}, {cos45, cos45}, {0.5, cos30}, {sin15, cos15}, {0, 1}}};
    const double steps = std::atan2(std::abs(v.y), std::abs(v.x)) / (pi / 12);
    const Vector direction = quarter[static_cast<std::size_t>(std::lround(steps))];
    return {std::copysign(direction.x, v.x), std::copysign(direction.y, v.y)};
}

/// `wanted` brought onto the ray that the angle allows; `start` is what it was when the drag began.
Vector held(Vector start, Vector wanted, HandleWay::Angle angle) {
    if (angle == HandleWay::Angle::free)
        return wanted;
    const Vector ray = angle == HandleWay::Angle::kept ? start : steppedDirection(wanted);
    const double square = dot(ray, ray);
    if (square == 0) // a retracted handle has no angle
        return wanted;
    return std::max(0.0, dot(wanted, ray) / square) * ray;
}

bool isHandle(GripKind kind) {
    return kind == GripKind::inHandle || kind == GripKind::outHandle;
}

/// Where a handle stands, also one that no segment uses but that is stored.
std::optional<Point> placeOf(const SplineCurve& curve, std::size_t knot, HandleSide side) {
    const KnotHandles placed = knotHandles(curve)[knot];
    const std::optional<Point>& used = side == HandleSide::in ? placed.in : placed.out;
    if (used || isAutomatic(curve.knots[knot]))
        return used;
    return side == HandleSide::in ? curve.knots[knot].in : curve.knots[knot].out;
}

SplineKnot parted(SplineKnot knot, HandleSide side, Point to, Vector opposite) {
    knot.join = Join::corner;
    (side == HandleSide::in ? knot.in : knot.out) = to;
    (side == HandleSide::in ? knot.out : knot.in) = knot.at + opposite;
    return knot;
}

void dragHandle(SplineCurve& curve, const GripId& id, const HandleWay& way) {
    const auto i = static_cast<std::size_t>(id.index);
    const HandleSide side = id.kind == GripKind::inHandle ? HandleSide::in : HandleSide::out;
    const std::optional<Point> place = i < curve.knots.size() ? placeOf(curve, i, side) : std::nullopt;
    if (!place)
        return;
    SplineKnot& knot = curve.knots[i];
    const Vector start = *place - knot.at;
    const Vector step = way.by - way.carried;
    const Vector end = held(start, start + step, way.angle);
    // Without a detour by way of the knot where nothing is held, so that no digit is lost.
    const Point to = end == start + step ? *place + step : knot.at + end;
    knot = way.opposite ? parted(knot, side, to, *way.opposite) : withHandleAt(knot, side, to);
}

void dragArrow(SplineCurve& curve, GripKind kind, const HandleWay& way) {
    const EndDerivatives ends = endDerivatives(curve, knotHandles(curve));
    const bool isStart = kind == GripKind::startDerivative;
    const std::optional<Vector>& old = isStart ? ends.start : ends.end;
    if (old)
        (isStart ? curve.startDerivative : curve.endDerivative) = held(*old, *old + (way.by - way.carried), way.angle);
}

/// The knot to which a handle or an arrow belongs.
GripId knotOf(const SplineCurve& curve, const GripId& id) {
    if (id.kind == GripKind::endDerivative)
        return {GripKind::point, static_cast<int>(curve.knots.size()) - 1};
    return {GripKind::point, id.kind == GripKind::startDerivative ? 0 : id.index};
}

} // namespace

SplineCurve withHandleDragged(const SplineCurve& curve, const GripId& id, const HandleWay& way) {
    SplineCurve dragged = curve;
    if (isHandle(id.kind))
        dragHandle(dragged, id, way);
    else if (id.kind == GripKind::startDerivative || id.kind == GripKind::endDerivative)
        dragArrow(dragged, id.kind, way);
    if (way.carried == Vector{})
        return dragged;
    const GripId knot = knotOf(curve, id);
    return withGripsMoved(dragged, std::span(&knot, 1), way.carried);
}

std::optional<SplineCurve> withHandleRetracted(const SplineCurve& curve, const GripId& id) {
    if (id.kind == GripKind::startDerivative)
        return withEndDerivatives(curve, {}, curve.endDerivative);
    if (id.kind == GripKind::endDerivative)
        return withEndDerivatives(curve, curve.startDerivative, {});
    const auto i = static_cast<std::size_t>(id.index);
    if (!isHandle(id.kind) || i >= curve.knots.size())
        return {};
    const bool isIn = id.kind == GripKind::inHandle;
    const std::vector<KnotHandles> handles = knotHandles(curve);
    if (!(isIn ? handles[i].in : handles[i].out))
        return {};
    SplineCurve retracted = withDerivativesHeld(curve, handles);
    SplineKnot& knot = retracted.knots[i];
    knot.join = Join::corner;
    knot.in = handles[i].in;
    knot.out = handles[i].out;
    (isIn ? knot.in : knot.out) = knot.at;
    return retracted;
}

std::optional<SplineCurve> readyToPull(SplineCurve curve, int knot) {
    if (!pullsHandles(curve))
        return {};
    SplineKnot& pulled = curve.knots[static_cast<std::size_t>(knot)];
    pulled.join = Join::symmetric;
    pulled.in = pulled.at;
    pulled.out = pulled.at;
    return curve;
}

std::optional<SplineCurve> closedAt(const SplineCurve& curve, int knot) {
    if (knot != 0 || curve.closed || curve.knots.size() < kFewestToClose)
        return {};
    return withClosed(curve, true);
}

} // namespace kriva
