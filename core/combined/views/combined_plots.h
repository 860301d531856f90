#pragma once

#include "core/combined/combined_curve.h"
#include "core/figure/plot/plot.h"
#include "core/work/work_budget.h"

namespace kriva {

/// y(x) of the runs and their slopes y'(x), under interpolation above those under approximation. None for incomplete
/// curves. Interpolation through 201 points takes some 0.1 s.
[[nodiscard]] std::optional<std::vector<PlotGroup>> plotsOf(const CombinedCurve& curve, WorkBudget& budget);

} // namespace kriva
