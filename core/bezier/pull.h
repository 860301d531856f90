#pragma once

#include "core/geometry/point.h"

#include <optional>

namespace kriva {

/// The curve pulled so that its point at t moves by the vector, through the least change (in the sum of squares) of the
/// inner control points; the ends stay. Nothing where no inner point has weight at t: at the ends, and below degree 2.
/// With weights w_i = B_i(t), each inner point moves by w_i / (sum of w_j^2) times the vector. O(degree^2).
[[nodiscard]] std::optional<Points> pulled(std::span<const Point> curve, double t, Vector by);

} // namespace kriva
