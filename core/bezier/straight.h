#pragma once

#include "core/geometry/point.h"

namespace kriva {

/// The length of the control polygon; 0 without points.
[[nodiscard]] double polygonLength(std::span<const Point> points);

/// Whether the curve is straight within 1e-9 of its polygon's length: no control point is farther than that from the
/// line through the first one and the one farthest from it. True for curves of one point and of degree 0 and 1.
[[nodiscard]] bool isStraight(std::span<const Point> curve);

} // namespace kriva
