#pragma once

#include "core/budget/work_budget.h"
#include "core/figure/plot/plot.h"
#include "core/sheets/spline/chain/spline.h"

namespace kriva {

/// The hodograph, the derivative by each segment's t as a curve in the plane of vectors. None for incomplete curves.
[[nodiscard]] std::optional<std::vector<PlotGroup>> plotsOf(const SplineCurve& curve, WorkBudget& budget);

} // namespace kriva
