#pragma once

#include "core/elevation/elevation.h"
#include "core/figure/plot/plot.h"
#include "core/work/work_budget.h"

namespace kriva {

/// The Bernstein polynomials of the degree; the gap between polygon and curve against the degree, with 1/N through its
/// last value, on logarithmic axes. None for incomplete curves. The gap is worked out for some hundred degrees.
[[nodiscard]] std::optional<std::vector<PlotGroup>> plotsOf(const ElevationCurve& curve, WorkBudget& budget);

} // namespace kriva
