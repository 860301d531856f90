#pragma once

#include "core/curve/editing/edited.h"
#include "core/curve/editing/grip.h"
#include "core/curve/file_error.h"
#include "core/figure/style/frame_place.h"
#include "core/sheets/elevation/elevation.h"

#include <optional>
#include <utility>

/// The edits of an elevation curve. Every sheet's curve has the same set, found by overloading.
namespace kriva {

/// Everything that can be dragged, points first, in their order.
[[nodiscard]] std::vector<Grip> grips(const ElevationCurve& curve);
[[nodiscard]] inline std::string_view layerOf(const ElevationCurve&, GripKind) {
    return "points";
}

/// The points of the Points table.
[[nodiscard]] inline std::size_t pointCount(const ElevationCurve& curve) {
    return curve.points.size();
}
[[nodiscard]] inline Point pointAt(const ElevationCurve& curve, int index) {
    return curve.points[static_cast<std::size_t>(index)];
}
/// How many points its results hold: they are limited over the whole sheet.
[[nodiscard]] inline std::size_t derivedPointCount(const ElevationCurve& curve) {
    return isIncomplete(curve) ? 0 : curve.points.size() + static_cast<std::size_t>(curve.times);
}
[[nodiscard]] std::optional<FileError> pointLimitError(const ElevationCurve& curve);

/// Whether all its coordinates are at most `limit` in absolute value.
[[nodiscard]] inline bool isWithin(const ElevationCurve& curve, double limit) {
    return areWithin(curve.points, limit);
}

/// All the named grips moved by the same vector; grips that do not exist are passed over.
[[nodiscard]] ElevationCurve withGripsMoved(const ElevationCurve& curve, std::span<const GripId> ids, Vector by);
[[nodiscard]] Edited<ElevationCurve> withPointAdded(ElevationCurve curve, Point at);
[[nodiscard]] ElevationCurve withPointsAdded(ElevationCurve curve, std::span<const Point> points);
/// The points of another curve behind its own, with all that belongs to them.
[[nodiscard]] ElevationCurve appended(ElevationCurve curve, const ElevationCurve& other);
/// `indices` ascending. The degree falls.
[[nodiscard]] Edited<ElevationCurve> withPointsRemoved(const ElevationCurve& curve, const std::vector<int>& indices);
/// Of the polynomial that runs through all points; nothing for incomplete curves.
[[nodiscard]] inline std::optional<int> polynomialDegree(const ElevationCurve& curve) {
    return isIncomplete(curve) ? std::nullopt : std::optional(static_cast<int>(curve.points.size()) - 1);
}
[[nodiscard]] Edited<ElevationCurve> reversed(const ElevationCurve& curve);

/// One degree elevation: one point more, the same curve; its inner points are all new. Nothing where the degree cannot
/// rise.
[[nodiscard]] std::optional<Edited<ElevationCurve>> withPointInserted(const ElevationCurve& curve, Point near);
/// The same: it has no place.
[[nodiscard]] inline std::optional<Edited<ElevationCurve>> withPointInsertedBehind(const ElevationCurve& curve,
                                                                                   std::optional<int>) {
    return withPointInserted(curve, Point{});
}
/// Not where it is not elevated, nor where the polygon has more points than a curve may have.
[[nodiscard]] bool canTakeElevatedPolygon(const ElevationCurve& curve);
/// The elevated polygon, which can be taken, as the control polygon: the same curve of a higher degree.
[[nodiscard]] ElevationCurve withElevatedPolygon(const ElevationCurve& curve);
/// One degree less, with how far the curve moves at most; nothing for degree 0 and 1. See reduce.h.
[[nodiscard]] std::optional<Refitted<ElevationCurve>> withDegreeReduced(const ElevationCurve& curve);
/// The curve pulled where it is nearest to `from`; nothing where it gives way to no pull. See pull.h.
[[nodiscard]] std::optional<ElevationCurve> withCurvePulled(const ElevationCurve& curve, Point from, Vector by);
/// Raised so many times; nothing elsewhere.
[[nodiscard]] std::optional<Frame<ElevationCurve>> atFrame(const ElevationCurve& curve, const FramePlace& place);

} // namespace kriva
