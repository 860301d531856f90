#pragma once

#include "core/curve/editing/edited.h"
#include "core/curve/editing/grip.h"
#include "core/curve/file_error.h"
#include "core/figure/style/frame_place.h"
#include "core/sheets/subdivision/subdivision.h"

#include <array>
#include <optional>
#include <span>
#include <utility>

/// The edits of a subdivision curve. Every sheet's curve has the same set, found by overloading; what follows that set
/// is this sheet's own. Multiplicities follow their points; the blossom always keeps as many arguments as the degree:
/// it gains t where the degree rises and loses its last arguments where it falls.
namespace kriva {

/// Everything that can be dragged: the points, in their order, each once.
[[nodiscard]] std::vector<Grip> grips(const SubdivisionCurve& curve);
[[nodiscard]] inline std::string_view layerOf(const SubdivisionCurve&, GripKind) {
    return "points";
}

/// The points of the Points table.
[[nodiscard]] inline std::size_t pointCount(const SubdivisionCurve& curve) {
    return curve.points.size();
}
[[nodiscard]] inline Point pointAt(const SubdivisionCurve& curve, int index) {
    return curve.points[static_cast<std::size_t>(index)];
}
/// How many points its results hold, those of all pieces: they are limited over the whole sheet.
[[nodiscard]] std::size_t derivedPointCount(const SubdivisionCurve& curve);
/// The most points that this curve may have, given its multiplicities and levels.
[[nodiscard]] std::size_t mostPoints(const SubdivisionCurve& curve);
[[nodiscard]] inline std::optional<FileError> pointLimitError(const SubdivisionCurve& curve) {
    return pointCountError(curve.points.size(), mostPoints(curve));
}

/// Whether all its coordinates are at most `limit` in absolute value.
[[nodiscard]] inline bool isWithin(const SubdivisionCurve& curve, double limit) {
    return areWithin(curve.points, limit);
}

/// All the named grips moved by the same vector; grips that do not exist are passed over.
[[nodiscard]] SubdivisionCurve withGripsMoved(const SubdivisionCurve& curve, std::span<const GripId> ids, Vector by);
/// The new point stands once.
[[nodiscard]] Edited<SubdivisionCurve> withPointAdded(SubdivisionCurve curve, Point at);
/// Each stands once.
[[nodiscard]] SubdivisionCurve withPointsAdded(SubdivisionCurve curve, std::span<const Point> points);
/// The points of another curve behind its own, with their multiplicities.
[[nodiscard]] SubdivisionCurve appended(SubdivisionCurve curve, const SubdivisionCurve& other);
/// `indices` ascending. The degree falls.
[[nodiscard]] Edited<SubdivisionCurve> withPointsRemoved(const SubdivisionCurve& curve,
                                                         const std::vector<int>& indices);
/// Of the polynomial that runs through all points, multiplicities counted; nothing for incomplete curves.
[[nodiscard]] inline std::optional<int> polynomialDegree(const SubdivisionCurve& curve) {
    return isIncomplete(curve) ? std::nullopt : std::optional(static_cast<int>(controlPointCount(curve)) - 1);
}
/// The same cut and the same blossom, seen from the other end.
[[nodiscard]] Edited<SubdivisionCurve> reversed(const SubdivisionCurve& curve);

/// The most control points of a curve that is cut `levels` times over: every curve's limit, and that of all its pieces.
[[nodiscard]] std::size_t mostControlPoints(int levels);
/// The most levels that a curve with so many control points may have.
[[nodiscard]] int mostLevels(std::size_t controlPoints);
/// The largest multiplicity that these points, at least one, may each have, the others being what they are; at least 1.
[[nodiscard]] int mostMultiplicity(const SubdivisionCurve& curve, std::span<const int> indices);

/// The point `index` stands so many times, at least once.
[[nodiscard]] SubdivisionCurve withMultiplicity(const SubdivisionCurve& curve, int index, int times);
/// t strictly between 0 and 1.
[[nodiscard]] SubdivisionCurve withT(SubdivisionCurve curve, double t);
/// From 0 to mostLevels.
[[nodiscard]] SubdivisionCurve withLevels(SubdivisionCurve curve, int levels);
/// As many arguments as the degree; with nothing, the blossom is not asked for.
[[nodiscard]] SubdivisionCurve withBlossom(SubdivisionCurve curve, std::optional<std::vector<double>> arguments);

/// The curves before and behind the cut at t, multiplicities written out. They keep everything but the blossom.
/// Nothing for incomplete curves.
[[nodiscard]] std::optional<std::array<SubdivisionCurve, 2>> dividedAtCut(const SubdivisionCurve& curve);

/// One degree elevation, multiplicities written out first: one control point more, the same curve; its inner points are
/// all new. Nothing where the degree cannot rise.
[[nodiscard]] std::optional<Edited<SubdivisionCurve>> withPointInserted(const SubdivisionCurve& curve, Point near);
/// The same: it has no place.
[[nodiscard]] inline std::optional<Edited<SubdivisionCurve>> withPointInsertedBehind(const SubdivisionCurve& curve,
                                                                                     std::optional<int>) {
    return withPointInserted(curve, Point{});
}
/// The curve pulled where it is nearest to `from`, multiplicities written out; nothing where it gives way to no pull.
/// See pull.h.
[[nodiscard]] std::optional<SubdivisionCurve> withCurvePulled(const SubdivisionCurve& curve, Point from, Vector by);
/// Cut so many times over, or at t; nothing where it cannot be.
[[nodiscard]] std::optional<Frame<SubdivisionCurve>> atFrame(const SubdivisionCurve& curve, const FramePlace& place);

} // namespace kriva
