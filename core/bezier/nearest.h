#pragma once

#include "core/geometry/point.h"

namespace kriva {

/// A place of a curve and how far it is from another point.
struct NearestPoint {
    double t = 0;
    Point at;
    double distance = 0;
};

/// The place of the curve nearest to the point: the least of all, not only a local one; of several equally near the
/// first. The distance is right to 1e-12 of the size of the figure, curve and point together. O(degree^2) per halving
/// that separates the candidates. For a curve of one place that place, with t = 0.
[[nodiscard]] NearestPoint nearest(std::span<const Point> curve, Point point);

/// The same for many points, as many as there are places.
void nearest(std::span<const Point> curve, std::span<const Point> points, std::span<NearestPoint> places);

/// A distance that no place of the curve falls below, quickly: that of its control points' box. O(degree).
[[nodiscard]] double leastDistance(std::span<const Point> curve, Point point);

} // namespace kriva
