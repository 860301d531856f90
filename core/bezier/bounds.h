#pragma once

#include "core/geometry/box.h"

namespace kriva {

/// The smallest box around the curve itself (not its control polygon), each side to a few ulp of the largest
/// coordinate; the box of the point for degree 0, empty without points.
[[nodiscard]] Box tightBounds(std::span<const Point> curve);

} // namespace kriva
