#pragma once

#include "core/geometry/point.h"

namespace kriva {

/// The middle points P1 - P0 of a C1 chain of parabolas over chords c_i = K_(i+1) - K_i, each P1 the mirror image of
/// the one before through their knot, the first chosen so that the sum of |P0 - 2 P1 + P2|^2 is least; for a single
/// chord its midpoint. The condition at a closed chain's first knot is left open. O(n).
[[nodiscard]] std::vector<Vector> quadraticMiddles(std::span<const Vector> chords);

} // namespace kriva
