#pragma once

#include "core/geometry/point.h"
#include "core/geometry/tolerance.h"

namespace kriva {

/// The finest tolerance of flattened(), as a share of the control polygon's box: smaller ones are taken as this, so
/// that the polyline stays within some 30,000 vertices for each degree.
inline constexpr double kFinestFlattening = 1e-9;

/// The vertices, all on the curve, of a polyline from its start to its end of which no point is farther from the curve
/// than the tolerance, nor any point of the curve from it: proved, not sampled. Two vertices where the curve is
/// straight between its ends, one for degree 0.
[[nodiscard]] Points flattened(std::span<const Point> curve, Tolerance tolerance);

} // namespace kriva
