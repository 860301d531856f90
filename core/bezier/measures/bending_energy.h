#pragma once

#include "core/geometry/point.h"

#include <optional>

namespace kriva {

/// The integral of the squared curvature over arc length, in 1/unit, relative error at most 1e-9; 0 for straight curves
/// (isStraight). Nothing where it diverges: where the speed |B'(t)| falls below 1e-9 of the polygon's length on a curve
/// that is not straight.
///
/// Proved as arcLength() is: pieces are halved until the integrand is analytic in a Bernstein ellipse around each,
/// which tells how many Gauss points are enough. Source: Trefethen, Is Gauss quadrature better than Clenshaw-Curtis?,
/// SIAM Review 50 (2008), theorem 4.5.
[[nodiscard]] std::optional<double> bendingEnergy(std::span<const Point> curve);

} // namespace kriva
