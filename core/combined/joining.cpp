#include "core/combined/joining.h"

#include <cassert>

namespace kriva {
namespace {

DoubleDouble crossProduct(const Tangent& a, const Tangent& b) {
    return a.x * b.y - a.y * b.x;
}

Tangent difference(const CurveEnd& from, const CurveEnd& to) {
    return {exactSum(to.x, -from.x), to.y - from.y};
}

/// from + step; 0 where no more is left of the two than their own roundings.
double ahead(const DoubleDouble& from, const DoubleDouble& step) {
    constexpr double kNoise = 0x1p-96; // some 8 bits above the unit of double-double arithmetic
    const double sum = (from + step).high;
    return std::abs(sum) <= kNoise * std::abs(step.high) ? 0 : sum;
}

/// The direction of the end, or that of the whole join for a single point.
Vector directionAt(const CurveEnd& end, Vector join) {
    return end.tangent ? end.tangent->vector() : join / length(join);
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

std::optional<Point> quadraticMiddle(const CurveEnd& from, const CurveEnd& to) {
    constexpr double kParallel = 1e-9; // least sine of the angle between the tangents
    constexpr double kNearest = 1e-9;  // of the middle point from an end, in distances of the ends
    constexpr double kFarthest = 100;
    const Tangent& start = *from.tangent;
    const Tangent& end = *to.tangent;
    const DoubleDouble sine = crossProduct(start, end);
    if (std::abs(sine.high) <= kParallel)
        return {};
    const Tangent way = difference(from, to);
    const double distance = length(way.vector());
    const DoubleDouble fromStart = crossProduct(way, end) / sine;
    const DoubleDouble toEnd = crossProduct(start, way) / sine;
    for (const double reach : {fromStart.high, toEnd.high})
        if (!(reach >= kNearest * distance && reach <= kFarthest * distance))
            return {};
    return Point{ahead(from.x, fromStart * start.x), ahead(from.y, fromStart * start.y)};
}

TangentPiece joinOf(const CurveEnd& from, const CurveEnd& to) {
    const Vector way = difference(from, to).vector();
    const Vector start = directionAt(from, way);
    const Vector end = directionAt(to, way);
    if (from.tangent && to.tangent)
        if (const std::optional<Point> middle = quadraticMiddle(from, to))
            return {{from.point(), *middle, to.point()}, start, end};
    const double reach = length(way) / 3;
    return {{from.point(), from.point() + reach * start, to.point() - reach * end, to.point()}, start, end};
}

std::vector<TangentPiece> pairOf(const CurveEnd& from, const CurveEnd& to) {
    assert(from.tangent && to.tangent);
    const Vector start = from.tangent->vector();
    const Vector end = to.tangent->vector();
    if (const std::optional<Point> middle = quadraticMiddle(from, to))
        return {{{from.point(), *middle, to.point()}, start, end}};
    const Vector way = difference(from, to).vector();
    const double reach = length(way) / 4;
    const Point left = from.point() + reach * start;
    const Point right = to.point() - reach * end;
    const Point between = midpoint(left, right);
    // From `way` rather than from the rounded points; its length is at least |way| / 2.
    const Vector through = way - reach * (start + end);
    const Vector tangent = through / length(through);
    return {{{from.point(), left, between}, start, tangent}, {{between, right, to.point()}, tangent, end}};
}

} // namespace kriva
