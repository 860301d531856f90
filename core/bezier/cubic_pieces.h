#pragma once

#include "core/geometry/point.h"
#include "core/geometry/tolerance.h"

#include <array>

namespace kriva {

using Cubic = std::array<Point, 4>;

/// Halvings after which cubicPieces stops. The error falls sixteenfold with each one, so that a curve of degree 200
/// with coordinates up to 1e9 is within its own rounding error long before.
inline constexpr int kDeepestCubicPiece = 24;

/// Cubics that follow the curve, joined end to end with its tangents, none farther from it than the tolerance at the
/// same parameter (a proved bound, not a sampled one). Degrees up to 3 come back exactly, as one cubic. Tolerances
/// below the rounding error of the curve's points, 4 (degree + 1) units in the last place of the largest coordinate,
/// are taken as that.
[[nodiscard]] std::vector<Cubic> cubicPieces(std::span<const Point> curve, Tolerance tolerance);

} // namespace kriva
