#pragma once

#include "core/curve/sheet.h"

/// The sheet `offset`: a polygon and some more at even distances to its left.
namespace kriva {

namespace limits {
inline constexpr int kOffsets = 100;
}

struct OffsetCurve {
    static constexpr std::string_view kSheet = "offset";
    static constexpr Caption kCaption = translatable("Caption", "Offset polygons");
    static constexpr Capabilities kCapabilities{.animation = true};

    std::string name;
    Points points;
    double distance = 1; ///< from one to the next; to the right where it is negative
    int times = 1;
    CurveStyle style;
    CurveView view;
    friend bool operator==(const OffsetCurve&, const OffsetCurve&) = default;
};

/// The polygon moved to the left by so much: its corners along the bisectors, at most kSharpest times as far.
[[nodiscard]] Points offsetPolygon(std::span<const Point> points, double distance);
inline constexpr double kSharpest = 4;

/// One after the other.
[[nodiscard]] std::vector<Points> offsetPolygons(const OffsetCurve& curve);

// What every sheet has, see sheet.h.

[[nodiscard]] inline bool isIncomplete(const OffsetCurve& curve) {
    return curve.points.size() < 2;
}
[[nodiscard]] inline std::size_t pointCount(const OffsetCurve& curve) {
    return curve.points.size();
}
[[nodiscard]] inline Point pointAt(const OffsetCurve& curve, int index) {
    return curve.points[static_cast<std::size_t>(index)];
}
[[nodiscard]] inline std::size_t derivedPointCount(const OffsetCurve& curve) {
    return curve.points.size() * static_cast<std::size_t>(curve.times);
}
[[nodiscard]] std::optional<FileError> pointLimitError(const OffsetCurve& curve);
[[nodiscard]] inline bool isWithin(const OffsetCurve& curve, double limit) {
    return areWithin(curve.points, limit);
}
[[nodiscard]] inline std::optional<int> polynomialDegree(const OffsetCurve&) {
    return {};
}
[[nodiscard]] inline std::vector<Grip> grips(const OffsetCurve& curve) {
    return pointGrips(curve.points);
}
[[nodiscard]] inline std::string_view layerOf(const OffsetCurve&, GripKind) {
    return "points";
}

[[nodiscard]] OffsetCurve withGripsMoved(const OffsetCurve& curve, std::span<const GripId> ids, Vector by);
[[nodiscard]] Edited<OffsetCurve> withPointAdded(OffsetCurve curve, Point at);
[[nodiscard]] OffsetCurve withPointsAdded(OffsetCurve curve, std::span<const Point> points);
[[nodiscard]] OffsetCurve appended(OffsetCurve curve, const OffsetCurve& other);
/// In the middle of the nearest edge, of the one behind a point, or of the last one.
[[nodiscard]] std::optional<Edited<OffsetCurve>> withPointInserted(const OffsetCurve& curve, Point near);
[[nodiscard]] std::optional<Edited<OffsetCurve>> withPointInsertedBehind(const OffsetCurve& curve,
                                                                         std::optional<int> index);
/// The nearest edge moves.
[[nodiscard]] std::optional<OffsetCurve> withCurvePulled(const OffsetCurve& curve, Point from, Vector by);
[[nodiscard]] Edited<OffsetCurve> withPointsRemoved(const OffsetCurve& curve, const std::vector<int>& indices);
[[nodiscard]] Edited<OffsetCurve> reversed(const OffsetCurve& curve);
/// So many times; nothing elsewhere.
[[nodiscard]] std::optional<Frame<OffsetCurve>> atFrame(const OffsetCurve& curve, const FramePlace& place);

[[nodiscard]] std::span<const LayerInfo> layersOf(const OffsetCurve& curve);
[[nodiscard]] Figure figureOf(const OffsetCurve& curve, const FigureContext& context);
[[nodiscard]] std::uint64_t drawingSteps(const OffsetCurve& curve);
[[nodiscard]] std::optional<std::vector<Result>> results(const OffsetCurve& curve, WorkBudget& budget);
/// The length of each polygon.
[[nodiscard]] std::optional<std::vector<PlotGroup>> plotsOf(const OffsetCurve& curve, WorkBudget& budget);
/// The corners of the last one.
[[nodiscard]] std::optional<std::vector<Table>> tablesOf(const OffsetCurve& curve, WorkBudget& budget);
void reportCurve(JsonWriter& json, const OffsetCurve& curve);
void readCurve(const JsonNode& node, OffsetCurve& curve);
void writeCurve(JsonWriter& json, const OffsetCurve& curve);

} // namespace kriva
