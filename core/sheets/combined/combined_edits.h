#pragma once

#include "core/curve/editing/edited.h"
#include "core/curve/editing/grip.h"
#include "core/curve/file_error.h"
#include "core/figure/style/frame_place.h"
#include "core/sheets/combined/combined.h"

#include <optional>
#include <utility>

/// The edits of a combined curve. Every sheet's curve has the same set, found by overloading; what follows that set is
/// this sheet's own. Corrections follow their pairs; those of pairs that an edit takes apart are dropped.
namespace kriva {

/// Everything that can be dragged: the points, in their order, then under Method::pairs the middle points of pairs; of
/// a pair of two quadratics, the point where these meet.
[[nodiscard]] std::vector<Grip> grips(const CombinedCurve& curve);
[[nodiscard]] inline std::string_view layerOf(const CombinedCurve&, GripKind kind) {
    return kind == GripKind::middle ? "middle-points" : "points";
}
/// The same where combine() has given its answer, empty while the curve is incomplete.
[[nodiscard]] std::vector<Grip> grips(const CombinedCurve& curve, const Combined& combined);

/// The points of the Points table.
[[nodiscard]] inline std::size_t pointCount(const CombinedCurve& curve) {
    return curve.points.size();
}
[[nodiscard]] inline Point pointAt(const CombinedCurve& curve, int index) {
    return curve.points[static_cast<std::size_t>(index)];
}
/// How many points its results hold that are limited over the whole sheet: none.
[[nodiscard]] inline std::size_t derivedPointCount(const CombinedCurve&) {
    return 0;
}
/// "tooManyPointsInRun" where a run of an interpolation is too long, at the longest one.
[[nodiscard]] std::optional<FileError> interpolationLimitError(const CombinedCurve& curve);
/// That too.
[[nodiscard]] std::optional<FileError> pointLimitError(const CombinedCurve& curve);

/// Whether all its coordinates, those of corrections too, are at most `limit` in absolute value.
[[nodiscard]] bool isWithin(const CombinedCurve& curve, double limit);

/// All the named grips moved by the same vector; grips that do not exist are passed over. A middle point that is moved
/// becomes a correction; those of moved points stay where they are.
[[nodiscard]] CombinedCurve withGripsMoved(const CombinedCurve& curve, std::span<const GripId> ids, Vector by);
[[nodiscard]] Edited<CombinedCurve> withPointAdded(CombinedCurve curve, Point at);
[[nodiscard]] CombinedCurve withPointsAdded(CombinedCurve curve, std::span<const Point> points);
/// The points of another curve behind its own, with the corrections of their pairs.
[[nodiscard]] CombinedCurve appended(CombinedCurve curve, const CombinedCurve& other);
/// `indices` ascending.
[[nodiscard]] Edited<CombinedCurve> withPointsRemoved(const CombinedCurve& curve, const std::vector<int>& indices);
/// Nothing: it has pieces.
[[nodiscard]] inline std::optional<int> polynomialDegree(const CombinedCurve&) {
    return {};
}
/// The same points from the other end. Runs keep their turning points in the new order, so the curve may change.
[[nodiscard]] Edited<CombinedCurve> reversed(const CombinedCurve& curve);

/// A new point before the point `index`; at the end where there is no such point.
[[nodiscard]] Edited<CombinedCurve> withPointInserted(const CombinedCurve& curve, int index, Point at);
/// The pair that starts at the point `pair` with this middle point, or with nothing with its own.
[[nodiscard]] CombinedCurve withCorrection(const CombinedCurve& curve, int pair, std::optional<Point> middle);
/// The pair that starts at the point `pair` as the quadratic that passes through a place at its parameter t, strictly
/// between 0 and 1.
[[nodiscard]] CombinedCurve withPairThrough(const CombinedCurve& curve, int pair, double t, Point place);

/// One more given point where the path is nearest to `near`; nothing below two points. Interpolations keep their shape;
/// other polynomials are fitted anew and change a little.
[[nodiscard]] std::optional<Edited<CombinedCurve>> withPointInserted(const CombinedCurve& curve, Point near);
/// The same in the middle of the path behind a point, before the last one where that is named, or where two neighbours
/// are farthest apart where none is.
[[nodiscard]] std::optional<Edited<CombinedCurve>> withPointInsertedBehind(const CombinedCurve& curve,
                                                                           std::optional<int> point);
/// Under Method::pairs, the pair nearest to `from` pulled there by its middle point, which becomes a correction;
/// nothing where another piece is nearer, or under another method.
[[nodiscard]] std::optional<CombinedCurve> withCurvePulled(const CombinedCurve& curve, Point from, Vector by);
/// After a step of the algorithm, which only hides layers; nothing elsewhere.
[[nodiscard]] std::optional<Frame<CombinedCurve>> atFrame(const CombinedCurve& curve, const FramePlace& place);

} // namespace kriva
