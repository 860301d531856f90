#pragma once

#include "core/curve/capabilities.h"
#include "core/figure/figure.h"
#include "core/figure/style/style.h"
#include "core/geometry/point.h"
#include "core/sheets/spline/chain/continuity.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

/// A chain of Bézier segments of one degree through knots. The tangents at the knots are placed by a rule, or by hand.
namespace kriva {

namespace limits {
inline constexpr int kSplineDegreeLow = 2;
inline constexpr int kSplineDegreeHigh = 5;
} // namespace limits

struct SplineKnot {
    /// What ties the two handles of a knot to each other.
    enum class Join {
        automatic, ///< the rule places both handles
        symmetric, ///< they mirror each other
        smooth,    ///< on one line through the knot, each with its own length
        corner,    ///< free
    };

    Point at;
    Join join = Join::automatic;
    std::optional<Point> in; ///< absolute positions; kept but ignored while the join is automatic
    std::optional<Point> out;
    friend bool operator==(const SplineKnot&, const SplineKnot&) = default;
};

struct SplineCurve {
    static constexpr std::string_view kSheet = "spline";
    static constexpr Caption kCaption = translatable("Caption", "Spline");
    static constexpr Capabilities kCapabilities{.handles = true,
                                                .closing = true,
                                                .pieces = true,
                                                .relations = true,
                                                .viewSettings = true,
                                                .outputLimits = true};
    enum class Rule { mirror, natural, clamped, catmullRom };

    std::string name;
    int degree = 3; ///< of every segment, 2 to 5
    Rule rule = Rule::mirror;
    bool closed = false;
    std::optional<Vector> startDerivative; ///< by the first segment's t, for Rule::clamped
    std::optional<Vector> endDerivative;
    std::vector<SplineKnot> knots;
    std::map<int, Points> inner; ///< replaced free control points by segment, for degrees 4 and 5
    CurveStyle style;
    CurveView view;
    friend bool operator==(const SplineCurve&, const SplineCurve&) = default;
};

/// A rule with its word in documents and its name for people.
struct NamedRule {
    SplineCurve::Rule rule;
    std::string_view word;
    Caption caption;
};
inline constexpr std::array<NamedRule, 4> kRules{
    {{SplineCurve::Rule::mirror, "mirror", translatable("Caption", "mirror")},
     {SplineCurve::Rule::natural, "natural", translatable("Caption", "natural")},
     {SplineCurve::Rule::clamped, "clamped", translatable("Caption", "clamped")},
     {SplineCurve::Rule::catmullRom, "catmull-rom", translatable("Caption", "Catmull–Rom")}}};

/// Fewer than 2 knots, or 3 where the curve is closed: still being drawn.
[[nodiscard]] bool isIncomplete(const SplineCurve& curve);

/// One between every two neighbouring knots, one more where the curve is closed; 0 while it is incomplete.
[[nodiscard]] std::size_t segmentCount(const SplineCurve& curve);

/// How many control points of a segment are neither knots nor next to one: 1 for degree 4, 2 for degree 5, else 0.
[[nodiscard]] std::size_t innerCount(int degree);

/// The free control points of a segment are its third and, for degree 5, fourth.
inline constexpr std::ptrdiff_t kFirstInner = 2;

/// The free control points of a segment of degree 4 or 5.
[[nodiscard]] inline Points innerOf(std::span<const Point> segment) {
    return {segment.begin() + kFirstInner, segment.end() - kFirstInner};
}

[[nodiscard]] inline bool isAutomatic(const SplineKnot& knot) {
    return knot.join == SplineKnot::Join::automatic;
}

/// The knot at which a segment ends.
[[nodiscard]] const SplineKnot& knotAfter(const SplineCurve& curve, std::size_t segment);

/// Whether a segment arrives at the knot, or leaves it.
[[nodiscard]] bool hasSegmentBefore(const SplineCurve& curve, std::size_t knot);
[[nodiscard]] bool hasSegmentAfter(const SplineCurve& curve, std::size_t knot);

struct SplineChain {
    std::vector<Points> segments;       ///< degree + 1 control points each, in the order of the knots
    std::vector<Continuity> continuity; ///< of each knot
    friend bool operator==(const SplineChain&, const SplineChain&) = default;
};

/// The segments of a curve and how they meet; both lists are empty while it is incomplete. Knots, stored handles of
/// cubics and replaced inner points stand in the segments bit for bit, every other control point is exact to a few
/// roundings of the distances between neighbouring knots plus one of its coordinates. Linear in the knots.
[[nodiscard]] SplineChain solveSpline(const SplineCurve& curve);

/// The segments alone, in half the time.
[[nodiscard]] std::vector<Points> segmentsOf(const SplineCurve& curve);

/// The same as a path, which holds the points of all segments in one list.
[[nodiscard]] Path pathOf(const SplineCurve& curve);

/// The segments for measuring what depends on their shape alone, each at a place of its own: where some control points
/// of a segment are not given by the curve, they are told relative to its first knot, so that it keeps its digits far
/// from the origin, and without the degrees that were only raised. Empty while the curve is incomplete. Linear.
[[nodiscard]] std::vector<Points> shapesOf(const SplineCurve& curve);

} // namespace kriva
