#pragma once

#include "core/curve/sheet.h"
#include "core/sheets/spline/chain/spline_curve.h"

/// What every sheet has, of the sheet `spline`: see sheet.h. The curve itself and its chain stand in
/// chain/spline_curve.h, the edits that only splines have in editing: chain_edits.h for a whole chain, joins.h and
/// handle_edits.h for single knots. Inner points of segments that an edit takes apart drop, the others follow.
namespace kriva {

namespace limits {
inline constexpr std::size_t kReportedSegments = 20'000; ///< of all curves of the sheet
inline constexpr std::size_t kPasses = 1'000'000;        ///< in their crossings and overlaps
} // namespace limits

/// The knots.
[[nodiscard]] inline std::size_t pointCount(const SplineCurve& curve) {
    return curve.knots.size();
}
[[nodiscard]] inline Point pointAt(const SplineCurve& curve, int index) {
    return curve.knots[static_cast<std::size_t>(index)].at;
}
[[nodiscard]] inline std::size_t derivedPointCount(const SplineCurve&) {
    return 0;
}
[[nodiscard]] std::optional<FileError> pointLimitError(const SplineCurve& curve);
/// Knots, handles, inner points and end derivatives. Handles that the rule places do not count.
[[nodiscard]] bool isWithin(const SplineCurve& curve, double limit);
[[nodiscard]] inline std::optional<int> polynomialDegree(const SplineCurve&) {
    return {};
}
/// The knots, in their order, then the handles, the inner points of degrees 4 and 5, and the tips of the end
/// derivatives where the rule asks for them. O(n).
[[nodiscard]] std::vector<Grip> grips(const SplineCurve& curve);
[[nodiscard]] std::string_view layerOf(const SplineCurve& curve, GripKind kind);

/// Stored handles and the end derivatives go with their knot, inner points where both knots of their segment go. A
/// moved handle keeps the promise of its join, and makes an automatic knot symmetric.
[[nodiscard]] SplineCurve withGripsMoved(const SplineCurve& curve, std::span<const GripId> ids, Vector by);
/// Automatic knots behind the last one.
[[nodiscard]] Edited<SplineCurve> withPointAdded(SplineCurve curve, Point at);
[[nodiscard]] SplineCurve withPointsAdded(SplineCurve curve, std::span<const Point> points);
/// With their joins and stored handles; their inner points too where both curves are of one degree.
[[nodiscard]] SplineCurve appended(SplineCurve curve, const SplineCurve& other);
/// One more knot where the chain is nearest to the point; nothing while it is incomplete. See withKnotInserted().
[[nodiscard]] std::optional<Edited<SplineCurve>> withPointInserted(const SplineCurve& curve, Point near);
/// One more knot in the middle of the segment behind a knot, of the one before the last knot of an open chain, or of
/// the longest one where no knot is named; nothing while the chain is incomplete. See withKnotInserted().
[[nodiscard]] std::optional<Edited<SplineCurve>> withPointInsertedBehind(const SplineCurve& curve,
                                                                         std::optional<int> knot);
/// See withSegmentPulled().
[[nodiscard]] std::optional<SplineCurve> withCurvePulled(const SplineCurve& curve, Point from, Vector by);
/// The other knots keep what they are.
[[nodiscard]] Edited<SplineCurve> withPointsRemoved(const SplineCurve& curve, const std::vector<int>& indices);
/// A closed curve still starts at its first knot. Handles that the mirror rule placed are stored, for it reads
/// differently backwards; those of the other rules are the same both ways.
[[nodiscard]] Edited<SplineCurve> reversed(const SplineCurve& curve);

// Pieces.

/// The path itself behind its own knots, with its handles: cubic, of lines with retracted handles, higher degrees
/// within a billionth of their size. A closed path closes a curve that had no knots before; gaps and pieces below a
/// millionth of its diagonal, which are roundings of its file, are left out. Joins where the handles lie on one line
/// are smooth, and symmetric where they are of one length. A path without pieces brings automatic knots.
[[nodiscard]] SplineCurve withPathAdded(SplineCurve curve, const Path& path);
/// Removes knots so that the shape changes least: the neighbours keep their tangents, and the lengths of their handles
/// towards each other are fitted to what goes, by least squares of the distances. They become smooth with stored
/// handles unless they are corners, so that the rest of the curve stays where it is. Parabolas have no handles and are
/// solved anew; nothing is fitted at open ends and where too few knots are left. Linear in the knots. Source:
/// orthogonal distance fitting by Gauss and Newton's method; Ahn, Least Squares Orthogonal Distance Fitting of Curves
/// and Surfaces in Space (2004), chapter 2.
[[nodiscard]] Refitted<SplineCurve> withPointsRemovedRefitted(const SplineCurve& curve,
                                                              const std::vector<int>& indices);

// Handles, and the arrows of end derivatives.

/// Parabolas have none.
[[nodiscard]] inline bool pullsHandles(const SplineCurve& curve) {
    return curve.degree > 2;
}
/// The knot becomes symmetric.
[[nodiscard]] std::optional<SplineCurve> readyToPull(SplineCurve curve, int knot);
/// An automatic knot becomes symmetric, and a corner where the other handle is left behind; else the join keeps its
/// promise. Where an angle is held, the handle comes as near to the pointer as its ray allows, at worst onto the knot.
/// A grip that does not exist, or no handle, changes nothing but what is carried. O(n).
[[nodiscard]] SplineCurve withHandleDragged(const SplineCurve& curve, const GripId& id, const HandleWay& way);
/// The handle on its knot, which becomes a corner, so that the other handle stays; the arrow of an end derivative gives
/// way to the natural chain's.
[[nodiscard]] std::optional<SplineCurve> withHandleRetracted(const SplineCurve& curve, const GripId& id);
/// On the first knot of at least three.
[[nodiscard]] std::optional<SplineCurve> closedAt(const SplineCurve& curve, int knot);

// What comes out of it.

[[nodiscard]] std::span<const LayerInfo> layersOf(const SplineCurve& curve);
[[nodiscard]] Figure figureOf(const SplineCurve& curve, const FigureContext& context);
[[nodiscard]] std::uint64_t drawingSteps(const SplineCurve& curve);
/// With the coefficients of every segment.
[[nodiscard]] std::optional<std::vector<Result>> results(const SplineCurve& curve, WorkBudget& budget);
/// The hodograph, the derivative by each segment's t as a curve in the plane of vectors.
[[nodiscard]] std::optional<std::vector<PlotGroup>> plotsOf(const SplineCurve& curve, WorkBudget& budget);
/// The coefficients of the segments in the powers of their own t; the same knots under every rule, with the least
/// length, bending energy and curvature marked.
[[nodiscard]] std::optional<std::vector<Table>> tablesOf(const SplineCurve& curve, WorkBudget& budget);
void reportCurve(JsonWriter& json, const SplineCurve& curve);
void readCurve(const JsonNode& node, SplineCurve& curve);
void writeCurve(JsonWriter& json, const SplineCurve& curve);
/// How much the curvature comb is scaled, times its automatic scale.
inline constexpr ViewSetting kCombScale{.name = "combScale", .least = 0.01, .most = 100, .usual = 1};
/// How many points of each segment its de Casteljau polyline has, both ends counted.
inline constexpr ViewSetting kPolylinePoints{
    .name = "polylinePoints", .least = 2, .most = 100, .usual = 8, .isWhole = true};
[[nodiscard]] std::span<const ViewSetting> viewSettingsOf(const SplineCurve& curve);

/// Where a report would list too many segments.
[[nodiscard]] std::optional<FileError> outputLimitError(std::span<const SplineCurve* const> curves, Output output);

/// How many crossings and where, and marks for those of curves that are shown.
[[nodiscard]] std::optional<Relations> relationsOf(std::span<const SplineCurve* const> curves, WorkBudget& budget);
[[nodiscard]] std::optional<FileError> reportTogether(JsonWriter& json, std::span<const SplineCurve* const> curves,
                                                      WorkBudget& budget);

} // namespace kriva
