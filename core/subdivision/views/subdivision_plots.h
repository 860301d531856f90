#pragma once

#include "core/figure/plot/plot.h"
#include "core/subdivision/subdivision.h"

namespace kriva {

/// The Bernstein polynomials of the degree, multiplicities counted, with the weights at t. None for incomplete curves.
[[nodiscard]] std::vector<PlotGroup> plotsOf(const SubdivisionCurve& curve);

} // namespace kriva
