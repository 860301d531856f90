#pragma once

#include "core/geometry/point.h"

#include <algorithm>

namespace kriva {

/// From p to the nearest point of the straight line between two points, which may be one.
[[nodiscard]] inline double distanceToSegment(Point p, Point from, Point to) {
    const Vector way = to - from;
    const double squared = dot(way, way);
    const double t = squared > 0 ? std::clamp(dot(p - from, way) / squared, 0.0, 1.0) : 0;
    return distance(p, from + t * way);
}

} // namespace kriva
