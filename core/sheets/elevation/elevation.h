#pragma once

#include "core/curve/sheet.h"

/// The sheet `elevation`: a Bézier curve and how often its degree is raised.
namespace kriva {

namespace limits {
inline constexpr int kElevations = 10'000;
}

struct ElevationCurve {
    static constexpr std::string_view kSheet = "elevation";
    static constexpr Caption kCaption = translatable("Caption", "Degree elevation");
    static constexpr Capabilities kCapabilities{.animation = true};

    std::string name;
    Points points;
    int times = 0;
    CurveStyle style;
    CurveView view;
    friend bool operator==(const ElevationCurve&, const ElevationCurve&) = default;
};

/// The same curve with its degree raised.
struct Elevation {
    Points polygon; ///< of degree n + times
    double gap = 0; ///< largest |b_i - B(i/N)|, in document units
};

/// The curve must be complete. O(n (n + times)).
[[nodiscard]] Elevation elevate(const ElevationCurve& curve);

// What every sheet has, see sheet.h.

[[nodiscard]] inline bool isIncomplete(const ElevationCurve& curve) {
    return curve.points.size() < 2;
}
[[nodiscard]] inline std::size_t pointCount(const ElevationCurve& curve) {
    return curve.points.size();
}
[[nodiscard]] inline Point pointAt(const ElevationCurve& curve, int index) {
    return curve.points[static_cast<std::size_t>(index)];
}
[[nodiscard]] inline std::size_t derivedPointCount(const ElevationCurve& curve) {
    return isIncomplete(curve) ? 0 : curve.points.size() + static_cast<std::size_t>(curve.times);
}
[[nodiscard]] std::optional<FileError> pointLimitError(const ElevationCurve& curve);
[[nodiscard]] inline bool isWithin(const ElevationCurve& curve, double limit) {
    return areWithin(curve.points, limit);
}
[[nodiscard]] inline std::optional<int> polynomialDegree(const ElevationCurve& curve) {
    return isIncomplete(curve) ? std::nullopt : std::optional(static_cast<int>(curve.points.size()) - 1);
}
[[nodiscard]] inline std::vector<Grip> grips(const ElevationCurve& curve) {
    return pointGrips(curve.points);
}
[[nodiscard]] inline std::string_view layerOf(const ElevationCurve&, GripKind) {
    return "points";
}

[[nodiscard]] ElevationCurve withGripsMoved(const ElevationCurve& curve, std::span<const GripId> ids, Vector by);
[[nodiscard]] Edited<ElevationCurve> withPointAdded(ElevationCurve curve, Point at);
[[nodiscard]] ElevationCurve withPointsAdded(ElevationCurve curve, std::span<const Point> points);
[[nodiscard]] ElevationCurve appended(ElevationCurve curve, const ElevationCurve& other);
/// One degree elevation: one point more, the same curve; its inner points are all new, wherever it was asked for.
/// Nothing where the degree cannot rise.
[[nodiscard]] std::optional<Edited<ElevationCurve>> withPointInserted(const ElevationCurve& curve, Point near);
[[nodiscard]] inline std::optional<Edited<ElevationCurve>> withPointInsertedBehind(const ElevationCurve& curve,
                                                                                   std::optional<int>) {
    return withPointInserted(curve, Point{});
}
/// See pull.h.
[[nodiscard]] std::optional<ElevationCurve> withCurvePulled(const ElevationCurve& curve, Point from, Vector by);
/// The degree falls.
[[nodiscard]] Edited<ElevationCurve> withPointsRemoved(const ElevationCurve& curve, const std::vector<int>& indices);
[[nodiscard]] Edited<ElevationCurve> reversed(const ElevationCurve& curve);
/// Raised so many times; nothing elsewhere.
[[nodiscard]] std::optional<Frame<ElevationCurve>> atFrame(const ElevationCurve& curve, const FramePlace& place);

[[nodiscard]] std::span<const LayerInfo> layersOf(const ElevationCurve& curve);
[[nodiscard]] Figure figureOf(const ElevationCurve& curve, const FigureContext& context);
[[nodiscard]] std::uint64_t drawingSteps(const ElevationCurve& curve);
[[nodiscard]] std::optional<std::vector<Result>> results(const ElevationCurve& curve, WorkBudget& budget);
/// The Bernstein polynomials of the degree; the gap between polygon and curve against the degree, with 1/N through its
/// last value, on logarithmic axes. The gap is worked out for some hundred degrees.
[[nodiscard]] std::optional<std::vector<PlotGroup>> plotsOf(const ElevationCurve& curve, WorkBudget& budget);
/// How the last elevation made each of its points: b_i' = i/N b_(i-1) + (1 - i/N) b_i with the actual numbers. Empty
/// where the degree is not raised.
[[nodiscard]] std::optional<std::vector<Table>> tablesOf(const ElevationCurve& curve, WorkBudget& budget);
void reportCurve(JsonWriter& json, const ElevationCurve& curve);
void readCurve(const JsonNode& node, ElevationCurve& curve);
void writeCurve(JsonWriter& json, const ElevationCurve& curve);

// What this one has besides.

/// Not where it is not elevated, nor where the polygon has more points than a curve may have.
[[nodiscard]] bool canTakeElevatedPolygon(const ElevationCurve& curve);
/// The elevated polygon, which can be taken, as the control polygon: the same curve of a higher degree.
[[nodiscard]] ElevationCurve withElevatedPolygon(const ElevationCurve& curve);
/// One degree less, with how far the curve moves at most; nothing for degree 0 and 1. See reduce.h.
[[nodiscard]] std::optional<Refitted<ElevationCurve>> withDegreeReduced(const ElevationCurve& curve);

} // namespace kriva
