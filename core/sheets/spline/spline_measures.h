#pragma once

#include "core/budget/work_budget.h"
#include "core/geometry/box.h"
#include "core/sheets/spline/chain/spline_curve.h"

namespace kriva {

/// What is measured along a whole chain.
struct SplineMeasures {
    SplineChain chain;
    std::vector<double> lengths; ///< of the segments
    double length = 0;
    Box bounds;
    int curvatureExtrema = 0;
    std::optional<double> bendingEnergy; ///< nothing where it diverges
};

/// The curve must be complete. Linear in the segments.
[[nodiscard]] std::optional<SplineMeasures> measure(const SplineCurve& curve, WorkBudget& budget);
[[nodiscard]] SplineMeasures measure(const SplineCurve& curve);

/// The largest absolute curvature along the chain, in 1/unit; nothing where it has none, at a cusp, or where the budget
/// has ended. Linear likewise.
[[nodiscard]] std::optional<double> largestCurvature(const SplineCurve& curve, WorkBudget& budget);

/// The coefficients B_0..B_n of a segment in the powers of its own t, 0 to 1: B_k = C(n, k) times the k-th forward
/// difference of the control points.
[[nodiscard]] std::vector<Vector> powerCoefficients(std::span<const Point> segment);

} // namespace kriva
