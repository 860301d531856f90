#pragma once

#include "core/figure/figure.h"
#include "core/sheets/spline/chain/spline_curve.h"

/// The layers of a spline that are made only where they are shown.
namespace kriva {

/// Marks where the curvature changes its sign: within the segments, and at knots where a bend goes over into one to the
/// other side without a corner. `shapes` are the segments for measuring (see shapesOf).
[[nodiscard]] Layer inflectionsLayer(const SplineCurve& curve, const SplineChain& chain,
                                     const std::vector<Points>& shapes);

/// "C2", "G1" ... at every knot between two segments, as the report has them.
[[nodiscard]] Layer continuityLayer(const SplineCurve& curve, const SplineChain& chain);

/// The chains that all four rules make of the same knots, joins and degree, each named where it is farthest from the
/// others. Nothing for parabolas, which follow no rule. Linear in the knots.
[[nodiscard]] Layer allRulesLayer(const SplineCurve& curve);

/// The polyline through `points` points of each segment, at equal steps of the parameter and both ends counted, at
/// least 2, each worked out by de Casteljau's algorithm. Ends where it started where the chain is closed.
[[nodiscard]] Points deCasteljauPolyline(std::span<const Points> segments, int points);

/// That polyline and its points, for comparison with how programs draw the curve itself.
[[nodiscard]] Layer polylineLayer(std::span<const Points> segments, int points);

} // namespace kriva
