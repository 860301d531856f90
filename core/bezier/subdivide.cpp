#include "core/bezier/subdivide.h"

#include "core/polynomial/casteljau.h"

#include <cassert>

namespace kriva {

namespace {

using Vectors = std::vector<Vector>;

Vectors vectorsFromStart(std::span<const Point> curve) {
    Vectors vectors(curve.size());
    writeFromStart(curve, vectors);
    return vectors;
}

Points pointsFrom(Point start, std::span<const Vector> vectors) {
    Points points;
    points.reserve(vectors.size());
    for (const Vector v : vectors)
        points.push_back(start + v);
    return points;
}

} // namespace

Triangle deCasteljau(std::span<const Point> curve, double t) {
    assert(!curve.empty());
    return deCasteljau(curve, std::vector<double>(curve.size() - 1, t));
}

Triangle deCasteljau(std::span<const Point> curve, std::span<const double> parameters) {
    assert(!curve.empty() && parameters.size() + 1 == curve.size());
    Triangle rows{Points(curve.begin(), curve.end())};
    Vectors row = vectorsFromStart(curve);
    for (const double t : parameters) {
        interpolateRow(std::span(row), t);
        row.pop_back();
        rows.push_back(pointsFrom(curve.front(), row));
    }
    return rows;
}

Halves split(std::span<const Point> curve, double t) {
    assert(!curve.empty());
    Vectors right = vectorsFromStart(curve);
    Vectors left(right.size());
    splitInPlace(std::span(right), std::span(left), t);
    Halves halves{pointsFrom(curve.front(), left), pointsFrom(curve.front(), right)};
    halves.right.back() = curve.back();
    return halves;
}

Points part(std::span<const Point> curve, double from, double to) {
    assert(!curve.empty() && 0 <= from && from <= to && to <= 1);
    Vectors row = vectorsFromStart(curve);
    Vectors left(row.size());
    if (to < 1) {
        splitInPlace(std::span(row), std::span(left), to);
        row = left;
    }
    // Of the part before `to`; from <= to, so this is at most 1. A part of no width at 0 is the first point alone.
    if (from > 0)
        splitInPlace(std::span(row), std::span(left), from / to);
    Points points = pointsFrom(curve.front(), row);
    if (to == 1)
        points.back() = curve.back();
    return points;
}

std::vector<Points> pieces(std::span<const Point> curve, double t, int levels) {
    assert(!curve.empty() && levels >= 0);
    std::vector<Vectors> level{vectorsFromStart(curve)};
    for (int i = 0; i < levels; ++i) {
        std::vector<Vectors> next;
        next.reserve(2 * level.size());
        for (Vectors& piece : level) {
            Vectors left(piece.size());
            splitInPlace(std::span(piece), std::span(left), t);
            next.push_back(std::move(left));
            next.push_back(std::move(piece));
        }
        level = std::move(next);
    }
    std::vector<Points> result;
    result.reserve(level.size());
    for (const Vectors& piece : level)
        result.push_back(pointsFrom(curve.front(), piece));
    result.back().back() = curve.back();
    return result;
}

Point blossom(std::span<const Point> curve, std::span<const double> arguments) {
    assert(!curve.empty() && arguments.size() + 1 == curve.size());
    Vectors row = vectorsFromStart(curve);
    for (const double u : arguments) {
        interpolateRow(std::span(row), u);
        row.pop_back();
    }
    return curve.front() + row.front();
}

} // namespace kriva
