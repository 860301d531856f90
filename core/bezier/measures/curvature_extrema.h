#pragma once

#include "core/geometry/point.h"

#include <optional>

namespace kriva {

/// The parameters in (0, 1), ascending, where the signed curvature changes its sign. None for straight curves
/// (isStraight). Decided in double-double arithmetic from the exact control points. O(degree^2) per root and halving.
[[nodiscard]] std::vector<double> inflections(std::span<const Point> curve);

/// The parameters, 1e-9 < t < 1 - 1e-9, ascending, where the derivative of the signed curvature changes its sign: where
/// the curvature turns from rising to falling or back, a cusp between included. None for straight curves. Decided
/// likewise.
[[nodiscard]] std::vector<double> curvatureExtrema(std::span<const Point> curve);

/// The derivative of the signed curvature by arc length at t, in 1/unit^2; its sign is right even where it nearly
/// vanishes. 0 for straight curves, nothing where the speed is zero.
[[nodiscard]] std::optional<double> curvatureSlope(std::span<const Point> curve, double t);

} // namespace kriva
