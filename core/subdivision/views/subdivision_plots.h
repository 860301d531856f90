#pragma once

#include "core/figure/plot/plot.h"
#include "core/subdivision/subdivision.h"
#include "core/work/work_budget.h"

namespace kriva {

/// The Bernstein polynomials of the degree, multiplicities counted, with the weights at t. None for incomplete curves.
[[nodiscard]] std::optional<std::vector<PlotGroup>> plotsOf(const SubdivisionCurve& curve, WorkBudget& budget);

} // namespace kriva
