#pragma once

#include "core/budget/work_budget.h"
#include "core/geometry/box.h"
#include "core/sheets/spline/chain/spline.h"

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

} // namespace kriva
