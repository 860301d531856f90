#pragma once

#include "core/geometry/point.h"

#include <optional>

namespace kriva {

/// The signed curvature at t (positive where the curve turns left), in 1/unit; nothing where the speed is zero.
[[nodiscard]] std::optional<double> curvature(std::span<const Point> curve, double t);

/// The direction in which the curve leaves its start, of length 1: towards the first control point that differs from
/// b_0; nothing where all coincide.
[[nodiscard]] std::optional<Vector> startTangent(std::span<const Point> curve);

/// The direction in which the curve arrives at its end, of length 1, likewise.
[[nodiscard]] std::optional<Vector> endTangent(std::span<const Point> curve);

/// The length of the control polygon; 0 for one point or none.
[[nodiscard]] double polygonLength(std::span<const Point> points);

/// Whether the curve is straight within 1e-9 of its polygon's length: no control point is farther than that from the
/// line through the first one and the one farthest from it. True for curves of one place and of degree 0 and 1.
[[nodiscard]] bool isStraight(std::span<const Point> curve);

} // namespace kriva
