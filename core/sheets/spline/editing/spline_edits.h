#pragma once

#include "core/curve/editing/edited.h"
#include "core/curve/editing/grip.h"
#include "core/curve/file_error.h"
#include "core/figure/figure.h"
#include "core/sheets/spline/chain/spline.h"

/// The edits of a spline that every sheet's curve has, found by overloading; joins.h and chain_edits.h hold the
/// spline's own. Inner points of segments that an edit takes apart drop, the others follow.
namespace kriva {

/// Everything that can be dragged: the knots, in their order, then the handles, the inner points of degrees 4 and 5,
/// and the tips of the end derivatives where the rule asks for them. O(n).
[[nodiscard]] std::vector<Grip> grips(const SplineCurve& curve);
[[nodiscard]] std::string_view layerOf(const SplineCurve& curve, GripKind kind);

/// The points of the Points table.
[[nodiscard]] inline std::size_t pointCount(const SplineCurve& curve) {
    return curve.knots.size();
}
[[nodiscard]] inline Point pointAt(const SplineCurve& curve, int index) {
    return curve.knots[static_cast<std::size_t>(index)].at;
}
/// How many points its results hold beyond its own: none that are limited.
[[nodiscard]] inline std::size_t derivedPointCount(const SplineCurve&) {
    return 0;
}
[[nodiscard]] std::optional<FileError> pointLimitError(const SplineCurve& curve);

/// Whether all its stored coordinates are at most `limit` in absolute value: knots, handles, inner points and end
/// derivatives. Handles that the rule places do not count.
[[nodiscard]] bool isWithin(const SplineCurve& curve, double limit);

/// All the named grips moved by the same vector; grips that do not exist are passed over. Stored handles and the end
/// derivatives go with their knot, inner points where both knots of their segment go. A moved handle keeps the promise
/// of its join, and makes an automatic knot symmetric.
[[nodiscard]] SplineCurve withGripsMoved(const SplineCurve& curve, std::span<const GripId> ids, Vector by);
/// An automatic knot behind the last one.
[[nodiscard]] Edited<SplineCurve> withPointAdded(SplineCurve curve, Point at);
/// Automatic knots behind the last one.
[[nodiscard]] SplineCurve withPointsAdded(SplineCurve curve, std::span<const Point> points);
/// The path itself behind its own knots, with its handles: cubic, of lines with retracted handles, higher degrees
/// within a billionth of their size. A closed path closes a curve that had no knots before; gaps and pieces below a
/// millionth of its diagonal, which are roundings of its file, are left out. Joins where the handles lie on one line
/// are smooth, and symmetric where they are of one length. A path without pieces brings automatic knots.
[[nodiscard]] SplineCurve withPathAdded(SplineCurve curve, const Path& path);
/// The knots of another curve behind its own, with their joins and stored handles; their inner points too where both
/// curves are of one degree.
[[nodiscard]] SplineCurve appended(SplineCurve curve, const SplineCurve& other);
/// `indices` ascending. The other knots keep what they are; removal.h has the removal that refits them.
[[nodiscard]] Edited<SplineCurve> withPointsRemoved(const SplineCurve& curve, const std::vector<int>& indices);
/// Nothing: it has pieces.
[[nodiscard]] inline std::optional<int> polynomialDegree(const SplineCurve&) {
    return {};
}
/// The same curve run through from its other end; a closed one still starts at its first knot. Handles that the mirror
/// rule placed are stored, for it reads differently backwards; those of the other rules are the same both ways.
[[nodiscard]] Edited<SplineCurve> reversed(const SplineCurve& curve);

} // namespace kriva
