#pragma once

#include "core/sheets/spline/chain/spline_curve.h"

namespace kriva {

/// P1 - P0 and P2 - P3 of a cubic segment: as seen from the knots, so that nothing is lost far from the origin.
struct SegmentHandles {
    Vector out;
    Vector in;
    friend constexpr bool operator==(const SegmentHandles&, const SegmentHandles&) = default;
};

/// K_(i+1) - K_i of every segment; empty while the curve is incomplete.
[[nodiscard]] std::vector<Vector> chordsOf(const SplineCurve& curve);

/// The handles of every segment: the stored ones at knots that are not automatic (a missing one counts as retracted
/// onto its knot), those of the curve's rule elsewhere. `chords` are the differences of neighbouring knots, one per
/// segment. Coincident knots are allowed under every rule. O(n).
/// Sources: mirror, the second-derivative condition at a segment's far end and P1' = 2 K - P2 at its start; natural
/// and clamped, C2 conditions in Bézier form (Farin, Curves and Surfaces for CAGD, 5th ed., chapter 9); catmullRom,
/// Barry and Goldman, SIGGRAPH 1988, with the centripetal exponent 1/2 of Lee, CAD 21 (1989).
[[nodiscard]] std::vector<SegmentHandles> cubicHandles(const SplineCurve& curve, std::span<const Vector> chords);

} // namespace kriva
