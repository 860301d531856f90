#pragma once

#include "core/geometry/point.h"

namespace kriva {

/// The control points of the same curve with its degree n raised `times` times to N = n + times, at once:
/// b_i' = sum over j of C(n, j) C(times, i - j) / C(N, i) b_j, all terms positive, O(n N), a few ulp at any `times`.
/// times = 0 returns the points unchanged, bit for bit.
/// Source: Farin, Curves and Surfaces for CAGD, 5th ed., formula (6.3).
[[nodiscard]] Points elevated(std::span<const Point> curve, int times);

/// max over i of |b_i - B(i/N)| for the control polygon of degree N of `curve`, the curve raised `times` times.
/// It falls like 1/N. `polygon` is elevated(curve, times).
[[nodiscard]] double elevationGap(std::span<const Point> curve, std::span<const Point> polygon);

} // namespace kriva
