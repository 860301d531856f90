#include "core/bezier/cubic_pieces.h"
#include "core/bezier/subdivide.h"
#include "core/geometry/box.h"
#include "core/sheets/spline/spline.h"

#include <algorithm>
#include <cmath>

namespace kriva {
namespace {

using Join = SplineKnot::Join;

/// Roundings of files, by the diagonal of a path or by the length of a handle.
constexpr double kRounding = 1e-6;

double reach(const Cubic& cubic) {
    return std::max({distance(cubic[0], cubic[1]), distance(cubic[0], cubic[2]), distance(cubic[0], cubic[3])});
}

/// A line stays one that is seen to be: its handles are retracted.
std::vector<Cubic> cubicsOf(std::span<const Point> piece, double diagonal) {
    constexpr double kOfHigherDegrees = 1e-9;
    if (piece.size() == 2)
        return {{piece[0], piece[0], piece[1], piece[1]}};
    return cubicPieces(piece, {kOfHigherDegrees * diagonal});
}

Cubic halfOf(const Points& half) {
    return {half[0], half[1], half[2], half[3]};
}

/// The pieces that are more than roundings. A closed spline has three at least.
std::vector<Cubic> cubicsOf(const Path& path) {
    constexpr std::size_t kLeastOfClosed = 3;
    const double diagonal = kriva::diagonal(boxOf(path.points));
    std::vector<Cubic> cubics;
    forEachPiece(path, [&](std::span<const Point> piece) {
        for (const Cubic& cubic : cubicsOf(piece, diagonal)) {
            if (reach(cubic) > kRounding * diagonal)
                cubics.push_back(cubic);
            else if (!cubics.empty())
                cubics.back()[3] = cubic[3];
        }
    });
    while (path.isClosed && !cubics.empty() && cubics.size() < kLeastOfClosed) {
        const Halves halves = split(cubics.back(), 0.5);
        cubics.back() = halfOf(halves.left);
        cubics.push_back(halfOf(halves.right));
    }
    return cubics;
}

/// What ties two handles together as they lie.
Join joinOf(const SplineKnot& knot) {
    if (!knot.in || !knot.out)
        return Join::corner;
    const Vector in = knot.at - *knot.in;
    const Vector out = *knot.out - knot.at;
    const double product = length(in) * length(out);
    if (dot(in, out) <= 0 || std::abs(cross(in, out)) > kRounding * product)
        return Join::corner;
    return length(in - out) <= kRounding * length(in) ? Join::symmetric : Join::smooth;
}

} // namespace

SplineCurve withPathAdded(SplineCurve curve, const Path& path) {
    if (path.degrees.empty())
        return withPointsAdded(std::move(curve), path.points);
    const std::vector<Cubic> cubics = cubicsOf(path);
    const std::size_t first = curve.knots.size();
    for (const Cubic& cubic : cubics) {
        if (curve.knots.size() == first)
            curve.knots.push_back({cubic[0], Join::corner, {}, {}});
        curve.knots.back().out = cubic[1];
        curve.knots.push_back({cubic[3], Join::corner, cubic[2], {}});
    }
    if (first == 0 && path.isClosed && !cubics.empty()) {
        curve.closed = true;
        curve.knots.front().in = curve.knots.back().in;
        curve.knots.pop_back();
    }
    if (first == 0)
        curve.degree = 3;
    for (std::size_t i = first; i < curve.knots.size(); ++i)
        curve.knots[i].join = joinOf(curve.knots[i]);
    return curve;
}

} // namespace kriva
