#pragma once

#include "core/geometry/point.h"

namespace kriva {

/// The control points of the same curve with its degree n raised `times` times to N = n + times, at once:
/// b_i' = sum over j of C(n, j) C(times, i - j) / C(N, i) b_j, all terms positive, at most O(n N), a few ulp of the
/// polygon's size at any `times`. times = 0 returns the points unchanged, bit for bit. A single point comes back
/// times + 1 times.
/// Source: Farin, Curves and Surfaces for CAGD, 5th ed., formula (6.3).
[[nodiscard]] Points elevated(std::span<const Point> curve, int times);

/// The same into an array of N + 1 points, apart from the curve's.
void elevate(std::span<const Point> curve, std::span<Point> raised);

/// max over i of |b_i - B(i/N)| for the control polygon of degree N of `curve` raised `times` times. It falls like
/// 1/N; 0 for degree 0 and 1. O(n N), from unrounded control points.
[[nodiscard]] double elevationGap(std::span<const Point> curve, int times);

} // namespace kriva
