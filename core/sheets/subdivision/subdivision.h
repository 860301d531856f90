#pragma once

#include "core/bezier/subdivide.h"
#include "core/curve/sheet.h"

#include <array>

/// The sheet `subdivision`: a Bézier curve that is cut at t, its pieces cut again and again; its points may stand
/// several times in a row.
namespace kriva {

namespace limits {
inline constexpr int kLevels = 16;
inline constexpr std::size_t kReportedSchemePoints = 2'000'000; ///< of de Casteljau, of all curves of the sheet
} // namespace limits

struct SubdivisionCurve {
    static constexpr std::string_view kSheet = "subdivision";
    static constexpr Caption kCaption = translatable("Caption", "Subdivision");
    static constexpr Capabilities kCapabilities{.animation = true, .viewSettings = true, .outputLimits = true};

    std::string name;
    Points points;
    std::vector<int> multiplicity; ///< of each point: always as many as points, all at least 1
    double t = 0.5;                ///< strictly between 0 and 1
    int levels = 1;
    std::optional<std::vector<double>> blossom; ///< as many arguments as the degree
    CurveStyle style;
    CurveView view;
    friend bool operator==(const SubdivisionCurve&, const SubdivisionCurve&) = default;
};

/// How many control points the curve has when each point is counted as often as it stands.
[[nodiscard]] std::size_t controlPointCount(const SubdivisionCurve& curve);

/// The control polygon: each point as often as it stands.
[[nodiscard]] Points controlPolygon(const SubdivisionCurve& curve);

/// A curve and what one cut at t tells of it.
struct Subdivision {
    Points polygon;    ///< the control polygon
    Triangle triangle; ///< de Casteljau's scheme at t; its last row is the point on the curve
    Halves halves;
    Vector derivative;            ///< at t, by t
    std::optional<Point> blossom; ///< where the curve asks for it; not finite where it is beyond the range of doubles
};

/// The curve must be complete. O(n^2).
[[nodiscard]] Subdivision subdivide(const SubdivisionCurve& curve);

/// The 2^levels pieces of a complete curve, in curve order. O(n^2 2^levels).
[[nodiscard]] std::vector<Points> pieces(const SubdivisionCurve& curve);

// What every sheet has, see sheet.h. Multiplicities follow their points; the blossom always keeps as many arguments as
// the degree: it gains t where the degree rises and loses its last arguments where it falls.

[[nodiscard]] inline bool isIncomplete(const SubdivisionCurve& curve) {
    return curve.points.size() < 2;
}
[[nodiscard]] inline std::size_t pointCount(const SubdivisionCurve& curve) {
    return curve.points.size();
}
[[nodiscard]] inline Point pointAt(const SubdivisionCurve& curve, int index) {
    return curve.points[static_cast<std::size_t>(index)];
}
/// Those of all pieces.
[[nodiscard]] std::size_t derivedPointCount(const SubdivisionCurve& curve);
[[nodiscard]] std::optional<FileError> pointLimitError(const SubdivisionCurve& curve);
[[nodiscard]] inline bool isWithin(const SubdivisionCurve& curve, double limit) {
    return areWithin(curve.points, limit);
}
/// Multiplicities counted.
[[nodiscard]] inline std::optional<int> polynomialDegree(const SubdivisionCurve& curve) {
    return isIncomplete(curve) ? std::nullopt : std::optional(static_cast<int>(controlPointCount(curve)) - 1);
}
/// Each point once.
[[nodiscard]] inline std::vector<Grip> grips(const SubdivisionCurve& curve) {
    return pointGrips(curve.points);
}
[[nodiscard]] inline std::string_view layerOf(const SubdivisionCurve&, GripKind) {
    return "points";
}

[[nodiscard]] SubdivisionCurve withGripsMoved(const SubdivisionCurve& curve, std::span<const GripId> ids, Vector by);
/// New points stand once.
[[nodiscard]] Edited<SubdivisionCurve> withPointAdded(SubdivisionCurve curve, Point at);
[[nodiscard]] SubdivisionCurve withPointsAdded(SubdivisionCurve curve, std::span<const Point> points);
[[nodiscard]] SubdivisionCurve appended(SubdivisionCurve curve, const SubdivisionCurve& other);
/// One degree elevation, multiplicities written out first: one control point more, the same curve; its inner points are
/// all new, wherever it was asked for. Nothing where the degree cannot rise.
[[nodiscard]] std::optional<Edited<SubdivisionCurve>> withPointInserted(const SubdivisionCurve& curve, Point near);
[[nodiscard]] inline std::optional<Edited<SubdivisionCurve>> withPointInsertedBehind(const SubdivisionCurve& curve,
                                                                                     std::optional<int>) {
    return withPointInserted(curve, Point{});
}
/// Multiplicities written out. See pull.h.
[[nodiscard]] std::optional<SubdivisionCurve> withCurvePulled(const SubdivisionCurve& curve, Point from, Vector by);
/// The degree falls.
[[nodiscard]] Edited<SubdivisionCurve> withPointsRemoved(const SubdivisionCurve& curve,
                                                         const std::vector<int>& indices);
/// The same cut and the same blossom, seen from the other end.
[[nodiscard]] Edited<SubdivisionCurve> reversed(const SubdivisionCurve& curve);
/// Cut so many times over, or at t; nothing where it cannot be.
[[nodiscard]] std::optional<Frame<SubdivisionCurve>> atFrame(const SubdivisionCurve& curve, const FramePlace& place);

[[nodiscard]] std::span<const LayerInfo> layersOf(const SubdivisionCurve& curve);
[[nodiscard]] Figure figureOf(const SubdivisionCurve& curve, const FigureContext& context);
[[nodiscard]] std::uint64_t drawingSteps(const SubdivisionCurve& curve);
/// Of the scheme what it ends in, of the pieces their number.
[[nodiscard]] std::optional<std::vector<Result>> results(const SubdivisionCurve& curve, WorkBudget& budget);
/// The Bernstein polynomials of the degree, multiplicities counted, with the weights at t.
[[nodiscard]] std::optional<std::vector<PlotGroup>> plotsOf(const SubdivisionCurve& curve, WorkBudget& budget);
/// De Casteljau's scheme at t, a column for each level; the weights of the control points at t; the two polygons that
/// the cut leaves; and, where the curve asks for it, the scheme of the blossom.
[[nodiscard]] std::optional<std::vector<Table>> tablesOf(const SubdivisionCurve& curve, WorkBudget& budget);
void reportCurve(JsonWriter& json, const SubdivisionCurve& curve);
/// Of a curve that is still being drawn the counts are not checked: multiplicities are cut or filled up to the points
/// it has.
void readCurve(const JsonNode& node, SubdivisionCurve& curve);
void writeCurve(JsonWriter& json, const SubdivisionCurve& curve);

/// The further t whose schemes are shown: more could not be told apart.
inline constexpr ViewSetting kFurtherParameters{.name = "parameters", .least = 0, .most = 1, .mostNumbers = 16};
[[nodiscard]] inline std::span<const ViewSetting> viewSettingsOf(const SubdivisionCurve&) {
    return {&kFurtherParameters, 1};
}

/// Where a report lists too many points of schemes.
[[nodiscard]] std::optional<FileError> outputLimitError(std::span<const SubdivisionCurve* const> curves, Output output);

// What this one has besides.

/// How many points its report lists of the scheme at t: all control points and what comes of them.
[[nodiscard]] std::size_t reportedSchemePoints(const SubdivisionCurve& curve);
/// The most points that this curve may have, given its multiplicities and levels.
[[nodiscard]] std::size_t mostPoints(const SubdivisionCurve& curve);
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

} // namespace kriva
