#pragma once

#include "core/budget/work_budget.h"
#include "core/figure/plot/plot.h"
#include "core/sheets/elevation/elevation.h"

namespace kriva {

/// The Bernstein polynomials of the degree; the gap between polygon and curve against the degree, with 1/N through its
/// last value, on logarithmic axes. None for incomplete curves. The gap is worked out for some hundred degrees.
[[nodiscard]] std::optional<std::vector<PlotGroup>> plotsOf(const ElevationCurve& curve, WorkBudget& budget);

} // namespace kriva
