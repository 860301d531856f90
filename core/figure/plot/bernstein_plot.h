#pragma once

#include "core/figure/plot/plot.h"

namespace kriva {

/// The Bernstein polynomials B_0..B_degree over [0, 1], marked where they are the weights of the control points at t.
[[nodiscard]] Plot bernsteinPlot(int degree, double t);

} // namespace kriva
