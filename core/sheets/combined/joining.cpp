#include "core/sheets/combined/joining.h"

#include <array>
#include <cassert>

namespace kriva {
namespace {

DoubleDouble crossProduct(const WideVector& a, const WideVector& b) {
    return a.x * b.y - a.y * b.x;
}

WideVector difference(const CurveEnd& from, const CurveEnd& to) {
    return {exactSum(to.x, -from.x), to.y - from.y};
}

/// from + step; 0 where no more is left of the two than their own roundings.
double ahead(const DoubleDouble& from, const DoubleDouble& step) {
    constexpr double kNoise = 0x1p-96; // some 8 bits above the unit of double-double arithmetic
    const double sum = (from + step).high;
    return std::abs(sum) <= kNoise * std::abs(step.high) ? 0 : sum;
}

/// The direction of the end, or that of the whole join for a single point.
WideVector directionAt(const CurveEnd& end, const WideVector& join) {
    if (end.tangent)
        return *end.tangent;
    const double distance = length(join.vector());
    return {join.x / distance, join.y / distance};
}

/// From the start to the middle point of the quadratic that joins the ends.
std::optional<WideVector> stepToMiddle(const CurveEnd& from, const CurveEnd& to) {
    constexpr double kParallel = 1e-9; // least sine of the angle between the tangents
    constexpr double kNearest = 1e-9;  // of the middle point from an end, in distances of the ends
    constexpr double kFarthest = 100;
    const Tangent& start = *from.tangent;
    const Tangent& end = *to.tangent;
    const DoubleDouble sine = crossProduct(start, end);
    if (std::abs(sine.high) <= kParallel)
        return {};
    const WideVector way = difference(from, to);
    const double distance = length(way.vector());
    const DoubleDouble fromStart = crossProduct(way, end) / sine;
    const DoubleDouble toEnd = crossProduct(start, way) / sine;
    for (const double reach : {fromStart.high, toEnd.high})
        if (!(reach >= kNearest * distance && reach <= kFarthest * distance))
            return {};
    return fromStart * start;
}

Point pointAhead(const CurveEnd& from, const WideVector& step) {
    return {ahead(from.x, step.x), ahead(from.y, step.y)};
}

/// The curve from one end to the other by its control points in between, as vectors from the start.
Points shapeBetween(std::span<const WideVector> inner, const WideVector& way) {
    std::vector<WideVector> all{WideVector{}};
    all.insert(all.end(), inner.begin(), inner.end());
    all.push_back(way);
    return shapeOf(all);
}

TangentPiece quadraticOf(const CurveEnd& from, const WideVector& stepToMiddle, const CurveEnd& to) {
    return {{from.point(), pointAhead(from, stepToMiddle), to.point()},
            from.tangent->vector(),
            to.tangent->vector(),
            shapeBetween(std::array{stepToMiddle}, difference(from, to))};
}

} // namespace

Tangent tangentOf(const DoubleDouble& slope, int direction) {
    // The larger component comes from the ratio below 1, so that no square overflows.
    const bool isSteep = std::abs(slope.high) > 1;
    DoubleDouble ratio = slope;
    if (isSteep)
        ratio = std::isfinite(slope.high) ? 1 / slope : DoubleDouble(0);
    const DoubleDouble large = direction / sqrt(1 + ratio * ratio);
    const DoubleDouble small = ratio * large;
    if (!isSteep)
        return {large, small};
    return slope.high > 0 ? Tangent{small, large} : Tangent{-small, -large};
}

TangentPiece joinOf(const CurveEnd& from, const CurveEnd& to) {
    const WideVector way = difference(from, to);
    const WideVector start = directionAt(from, way);
    const WideVector end = directionAt(to, way);
    if (from.tangent && to.tangent)
        if (const std::optional<WideVector> step = stepToMiddle(from, to))
            return quadraticOf(from, *step, to);
    const double reach = length(way.vector()) / 3;
    const WideVector out = reach * start;
    const WideVector in = reach * end;
    return {{from.point(), from.point() + out.vector(), to.point() - in.vector(), to.point()},
            start.vector(),
            end.vector(),
            shapeBetween(std::array{out, way - in}, way)};
}

std::vector<TangentPiece> pairOf(const CurveEnd& from, const CurveEnd& to) {
    assert(from.tangent && to.tangent);
    if (const std::optional<WideVector> step = stepToMiddle(from, to))
        return {quadraticOf(from, *step, to)};
    const WideVector way = difference(from, to);
    const double reach = length(way.vector()) / 4;
    const WideVector out = reach * *from.tangent;
    const WideVector in = reach * *to.tangent;
    const Point left = from.point() + out.vector();
    const Point right = to.point() - in.vector();
    const Point between = midpoint(left, right);
    // From `way` rather than from the rounded points; its length is at least |way| / 2.
    const WideVector through = way - out - in;
    const Vector tangent = through.vector() / length(through.vector());
    const DoubleDouble half = 0.5;
    return {{{from.point(), left, between},
             from.tangent->vector(),
             tangent,
             shapeBetween(std::array{out}, half * (way + out - in))},
            {{between, right, to.point()},
             tangent,
             to.tangent->vector(),
             shapeBetween(std::array{half * through}, half * (way - out + in))}};
}

} // namespace kriva
