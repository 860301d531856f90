#pragma once

#include "core/geometry/point.h"
#include "core/geometry/tolerance.h"

namespace kriva {

/// The polyline with fewer of its vertices, the first and the last among them: those left out lie within the tolerance
/// of the line that stands for them. O(n); fewest vertices are not promised. Source: Sklansky, Gonzalez, Fast polygonal
/// approximation of digitized curves, Pattern Recognition 12 (1980).
[[nodiscard]] Points simplified(std::span<const Point> polyline, Tolerance tolerance);

} // namespace kriva
