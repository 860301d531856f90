#pragma once

#include "core/geometry/point.h"

namespace kriva {

/// The length of the curve, relative error at most 1e-12, cusps and repeated points included; 0 where all control
/// points coincide and for degree 0. Proved, not estimated: the curve is halved until the speed of each piece has no
/// singularity inside a Bernstein ellipse around it, and the ellipse tells how many Gauss points are enough. At degrees
/// up to 3 these singularities are known, which takes a fifth of the time (speed_integral.h).
/// Source: Trefethen, Is Gauss quadrature better than Clenshaw-Curtis?, SIAM Review 50 (2008), theorem 4.5.
[[nodiscard]] double arcLength(std::span<const Point> curve);

/// The parameter in [0, 1] at which the curve has run through this much of its length; 0 for a length below 0 and for
/// a curve without length, 1 for a length beyond the whole.
[[nodiscard]] double parameterAtLength(std::span<const Point> curve, double length);

} // namespace kriva
