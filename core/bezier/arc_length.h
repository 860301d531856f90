#pragma once

#include "core/geometry/point.h"

namespace kriva {

/// The length of the curve, relative error at most 1e-12, cusps and repeated points included; 0 where all control
/// points coincide.
[[nodiscard]] double arcLength(std::span<const Point> curve);

} // namespace kriva
