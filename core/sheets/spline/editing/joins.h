#pragma once

#include "core/sheets/spline/chain/spline_curve.h"

/// The handles of knots as a person edits them, and the promises of the joins. Degrees 4 and 5 show the handles of the
/// cubic that they are raised from; parabolas have none.
namespace kriva {

/// Where the handles of a knot stand; nothing on a side that no segment uses.
struct KnotHandles {
    std::optional<Point> in;
    std::optional<Point> out;
    friend bool operator==(const KnotHandles&, const KnotHandles&) = default;
};

/// One entry per knot, all empty for parabolas and incomplete curves. O(n).
[[nodiscard]] std::vector<KnotHandles> knotHandles(const SplineCurve& curve);

/// The derivatives by t at open ends that the rule `clamped` decides; nothing where it does not.
struct EndDerivatives {
    std::optional<Vector> start;
    std::optional<Vector> end;
};
[[nodiscard]] EndDerivatives endDerivatives(const SplineCurve& curve, std::span<const KnotHandles> handles);

enum class HandleSide { in, out };

/// The knot with one handle moved. An automatic knot becomes symmetric; a symmetric one mirrors the handle, a smooth
/// one keeps the other in line with it and as long as it was (unchanged where the moved handle is on the knot).
[[nodiscard]] SplineKnot withHandleAt(SplineKnot knot, HandleSide side, Point to);

/// The knots (indices, in any order) with another join. What the new join promises is made true with the least change:
/// symmetric takes the mean of both handles, smooth turns them into their common direction. Automatic knots give up
/// their stored handles.
[[nodiscard]] SplineCurve withJoin(const SplineCurve& curve, std::span<const int> knots, SplineKnot::Join join);

/// The knot with both handles stored where they stand, about to be changed one by one: smooth unless it is a corner.
[[nodiscard]] SplineKnot loosened(SplineKnot knot, const KnotHandles& handles);

/// The curve with end derivatives held as they are, where turning knots into stored ones would otherwise change them:
/// one that is not given follows from the natural chain, which is not the clamped one if the other is given.
[[nodiscard]] SplineCurve withDerivativesHeld(SplineCurve curve, std::span<const KnotHandles> handles);

/// The curve with all its counts valid again: every handle that a segment uses is there (the mirror image of its
/// opposite, else where the rule would place it), and no inner points belong to no segment or are too many or few.
[[nodiscard]] SplineCurve repaired(SplineCurve curve);

} // namespace kriva
