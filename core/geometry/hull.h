#pragma once

#include "core/geometry/point.h"

namespace kriva {

/// The corners of the convex hull, counterclockwise from the leftmost (of several the lowest), none between two others
/// on a line. One point for coincident points, two for points on a line, none for none. O(n log n), turns decided by
/// the exact products of the rounded differences. Source: Andrew, Another efficient algorithm for convex hulls in two
/// dimensions, Inf. Proc. Letters 9 (1979).
[[nodiscard]] Points convexHull(std::span<const Point> points);

} // namespace kriva
