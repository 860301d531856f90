#pragma once

#include "core/geometry/point.h"

#include <string_view>

namespace kriva {

/// How two segments meet at a knot, the strongest first in the order of the report.
enum class Continuity { c2, g2, c1, g1, c0, end };

/// "C2", "G2", "C1", "G1", "C0", "end".
[[nodiscard]] std::string_view nameOf(Continuity continuity);

/// How the segment `leaving` goes on where `arriving` ends, for two control polygons of at least two points each that
/// may be given in coordinates of their own (only their shapes count). With L the longer of the two polygons and D the
/// derivatives by t: C1 where |D+ - D-| <= 1e-9 L, C2 where the second derivatives agree so too; G1 where both |D|
/// exceed 1e-9 L and the sine of their angle is at most 1e-9, G2 where the curvatures agree within 1e-9 of the largest
/// of |k-|, |k+| and 1/L. Two polygons without any length are C2. Never `end`.
[[nodiscard]] Continuity continuityBetween(std::span<const Point> arriving, std::span<const Point> leaving);

} // namespace kriva
