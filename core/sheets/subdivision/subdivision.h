#pragma once

#include "core/bezier/subdivide.h"
#include "core/curve/capabilities.h"
#include "core/figure/caption.h"
#include "core/figure/style/style.h"

#include <optional>
#include <string>
#include <string_view>

namespace kriva {

/// A Bézier curve that is cut at t, its pieces cut again and again; its points may stand several times in a row.
struct SubdivisionCurve {
    static constexpr std::string_view kSheet = "subdivision";
    static constexpr Caption kCaption = Caption::subdivision;
    static constexpr Capabilities kCapabilities{.animation = true, .outputLimits = true};

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

/// Still being drawn: fewer points than a curve needs.
[[nodiscard]] inline bool isIncomplete(const SubdivisionCurve& curve) {
    return curve.points.size() < 2;
}

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

} // namespace kriva
