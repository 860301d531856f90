#pragma once

#include "core/geometry/point.h"

#include <optional>

/// Chains that join smoothly, from the chords c_i = K_(i+1) - K_i between their knots alone.
namespace kriva {

/// The tangents h_0..h_n, as handles out - K_i, of the C2 chain of cubics over n >= 1 chords c_i = K_(i+1) - K_i with
/// uniform parameter. An end without a given tangent is natural: its second derivative vanishes. O(n).
/// Source: the second derivatives of neighbouring segments agree where h_(i-1) + 4 h_i + h_(i+1) = c_(i-1) + c_i;
/// a natural start has 2 h_0 + h_1 = c_0. Farin, Curves and Surfaces for CAGD, 5th ed., section 9.3.
[[nodiscard]] std::vector<Vector> c2Tangents(std::span<const Vector> chords, std::optional<Vector> start,
                                             std::optional<Vector> end);

/// The same for a closed chain of n >= 3 chords, C2 at every knot; h_n = h_0. O(n).
[[nodiscard]] std::vector<Vector> periodicC2Tangents(std::span<const Vector> chords);

/// The middle points P1 - P0 of a C1 chain of parabolas over chords c_i = K_(i+1) - K_i, each P1 the mirror image of
/// the one before through their knot, the first chosen so that the sum of |P0 - 2 P1 + P2|^2 is least; for a single
/// chord its midpoint. The condition at a closed chain's first knot is left open. O(n).
[[nodiscard]] std::vector<Vector> quadraticMiddles(std::span<const Vector> chords);

} // namespace kriva
