#pragma once

#include "core/budget/work_budget.h"
#include "core/figure/plot/plot.h"
#include "core/sheets/subdivision/subdivision.h"

namespace kriva {

/// The Bernstein polynomials of the degree, multiplicities counted, with the weights at t. None for incomplete curves.
[[nodiscard]] std::optional<std::vector<PlotGroup>> plotsOf(const SubdivisionCurve& curve, WorkBudget& budget);

} // namespace kriva
