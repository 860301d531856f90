#pragma once

#include "core/sheets/spline/chain/spline_curve.h"

/// Edits of the handles of many knots at once (indices in any order). Sides that no segment uses stay as they are; so
/// do parabolas, which have no handles. Each O(n).
namespace kriva {

/// Both handles of corners turned into their common direction, each as long as it was; the corners stay corners. Knots
/// of other joins are in line already.
[[nodiscard]] SplineCurve withHandlesAligned(const SplineCurve& curve, std::span<const int> knots);

/// Both handles as long as their mean, in the directions they have; a retracted one comes out opposite to the other.
/// Automatic knots become symmetric.
[[nodiscard]] SplineCurve withHandlesEqualized(const SplineCurve& curve, std::span<const int> knots);

/// Retracted handles where the curve's rule would place them; at a smooth knot in line with the other handle.
[[nodiscard]] SplineCurve withHandlesPulledOut(const SplineCurve& curve, std::span<const int> knots);

/// Both handles on their knots, which become corners.
[[nodiscard]] SplineCurve withHandlesRetracted(const SplineCurve& curve, std::span<const int> knots);

} // namespace kriva
