#include "core/bezier/cubic_pieces.h"

#include "core/bezier/elevate.h"
#include "core/bezier/subdivide.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace kriva {

namespace {

Cubic asCubic(std::span<const Point> curve) {
    const Points raised = elevated(curve, static_cast<int>(4 - curve.size()));
    return {raised[0], raised[1], raised[2], raised[3]};
}

/// The cubic with the ends and the end derivatives of the curve.
Cubic hermiteCubic(std::span<const Point> curve) {
    const double third = static_cast<double>(curve.size() - 1) / 3;
    const Point start = curve.front();
    const Point end = curve.back();
    return {start, start + third * (curve[1] - start), end - third * (end - curve[curve.size() - 2]), end};
}

/// Whether the curve is nowhere farther from the cubic than the tolerance, at the same parameter: the difference of two
/// curves of one degree lies in the hull of the differences of their control points. Control point i of the cubic
/// raised to degree n has the weights C(i, j) C(n - i, 3 - j) / C(n, 3).
bool isWithin(double tolerance, std::span<const Point> curve, const Cubic& cubic) {
    const auto n = static_cast<double>(curve.size() - 1);
    const double all = n * (n - 1) * (n - 2);
    for (std::size_t k = 0; k < curve.size(); ++k) {
        const auto i = static_cast<double>(k);
        const double r = n - i;
        const Vector raised =
            r * (r - 1) * (r - 2) / all * (cubic[0] - curve[k]) + 3 * i * r * (r - 1) / all * (cubic[1] - curve[k]) +
            3 * i * (i - 1) * r / all * (cubic[2] - curve[k]) + i * (i - 1) * (i - 2) / all * (cubic[3] - curve[k]);
        if (length(raised) > tolerance)
            return false;
    }
    return true;
}

void append(std::span<const Point> curve, double tolerance, int depth, std::vector<Cubic>& result) {
    const Cubic cubic = hermiteCubic(curve);
    if (depth == 0 || isWithin(tolerance, curve, cubic)) {
        result.push_back(cubic);
        return;
    }
    const Halves halves = split(curve, 0.5);
    append(halves.left, tolerance, depth - 1, result);
    append(halves.right, tolerance, depth - 1, result);
}

} // namespace

std::vector<Cubic> cubicPieces(std::span<const Point> curve, Tolerance tolerance) {
    assert(!curve.empty());
    if (curve.size() <= 4)
        return {asCubic(curve)};
    double largest = 0;
    for (const Point p : curve)
        largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    const double rounding = 4 * static_cast<double>(curve.size()) * std::numeric_limits<double>::epsilon() * largest;
    std::vector<Cubic> result;
    append(curve, std::max(tolerance.distance, rounding), kDeepestCubicPiece, result);
    return result;
}

} // namespace kriva
