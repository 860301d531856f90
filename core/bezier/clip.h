#pragma once

#include "core/geometry/box.h"

namespace kriva {

/// The parts of a curve that run inside a box, in its direction, each a Bézier curve of the same degree whose ends
/// stand on the sides of the box; parts that only touch it are left out. A curve that lies inside is given as it is.
/// Ends are exact to a few roundings of the largest coordinate. Costs a root search for each side that the curve
/// crosses.
[[nodiscard]] std::vector<Points> clipped(std::span<const Point> curve, const Box& box);

} // namespace kriva
