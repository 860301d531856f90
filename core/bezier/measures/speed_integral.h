#pragma once

#include "core/bezier/measures/hodograph_factors.h"

namespace kriva {

/// The integral of |c(t)| over [0, 1], relative error at most 1e-12, for coefficients of which the largest component
/// lies between 1e-60 and 1e60; 0 where all are 0.
///
/// Proved: as a complex polynomial c has two zeros, |c|^2 is the product of c and its mirror image, and |c| is analytic
/// where neither has a zero. [0, 1] is halved until the Bernstein ellipse around each part that reaches to the nearer
/// zero tells that a Gauss rule of few points is enough (gauss_bounds.h); next to a zero, see CuspWindow.
[[nodiscard]] double integralOfSpeed(const QuadraticHodograph& c);

} // namespace kriva
