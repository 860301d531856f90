#pragma once

#include "core/budget/work_budget.h"
#include "core/figure/plot/plot.h"
#include "core/sheets/combined/combined_curve.h"

namespace kriva {

/// y(x) of the runs and their slopes y'(x), under interpolation above those under approximation. None for incomplete
/// curves. Interpolation through 201 points takes some 0.1 s.
[[nodiscard]] std::optional<std::vector<PlotGroup>> plotsOf(const CombinedCurve& curve, WorkBudget& budget);

} // namespace kriva
