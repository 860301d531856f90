#pragma once

#include "core/geometry/point.h"
#include "core/geometry/tolerance.h"

#include <array>

namespace kriva {

using Cubic = std::array<Point, 4>;

/// Cubics that follow the curve, joined end to end, none farther from it than the tolerance at the same parameter
/// (a proved bound, not a sampled one). Degrees up to 3 come back exactly, as one cubic.
[[nodiscard]] std::vector<Cubic> cubicPieces(std::span<const Point> curve, Tolerance tolerance);

} // namespace kriva
