#pragma once

#include "core/geometry/box.h"

#include <array>
#include <optional>

namespace kriva {

/// A part of a polynomial segment of low degree while its contacts with others are sought: a plain value without heap,
/// for there are many. Its control points are those of the part; `from` and `to` are parameters of the segment.
struct Arc {
    static constexpr std::size_t kMostDegree = 5;

    std::array<Point, kMostDegree + 1> points{};
    std::size_t degree = 0;
    double from = 0;
    double to = 1;
    Box box; ///< of the control points

    [[nodiscard]] std::span<const Point> polygon() const { return {points.data(), degree + 1}; }
    [[nodiscard]] Point front() const { return points[0]; }
    [[nodiscard]] Point back() const { return points[degree]; }
    [[nodiscard]] Vector chord() const { return back() - front(); }
    /// The larger side of the box.
    [[nodiscard]] double size() const { return std::max(box.width(), box.height()); }
    /// The parameter of the segment at the arc's own t.
    [[nodiscard]] double parameter(double t) const { return from + t * (to - from); }
};

/// Where coordinates of arcs start and what they count in: a power of two about the size of the whole figure, so that
/// no product of two of them vanishes.
struct ArcFrame {
    Point origin;
    double unit = 1;
};

/// A whole segment of degree 1 to 5 in the frame.
[[nodiscard]] Arc arcOf(std::span<const Point> segment, const ArcFrame& frame);

struct ArcHalves {
    Arc left;
    Arc right;
};

/// Cut in the middle. The ends stay bit for bit.
[[nodiscard]] ArcHalves halved(const Arc& arc);

/// The part between two of the arc's own parameters, 0 <= from < to <= 1.
[[nodiscard]] Arc part(const Arc& arc, double from, double to);

/// The same arc run through the other way: from > to.
[[nodiscard]] Arc reversed(const Arc& arc);

/// Point and first derivative by the arc's own t, which may lie outside [0, 1].
struct ArcPoint {
    Point at;
    Vector velocity;
};
[[nodiscard]] ArcPoint evaluate(const Arc& arc, double t);

/// All tangent directions of an arc, between two bounding ones less than a half turn apart.
struct TangentCone {
    Vector right;
    Vector left;
};

/// Nothing where the control polygon turns back against the chord. Source: Sederberg, Meyers, Loop detection in surface
/// patch intersections, CAGD 5 (1988).
[[nodiscard]] std::optional<TangentCone> tangentCone(const Arc& arc);

/// Whether no direction of one cone is parallel to one of the other, by more than the noise of directions. Arcs with
/// such cones meet once at most.
[[nodiscard]] bool areTransversal(const TangentCone& a, const TangentCone& b);

/// Whether a straight strip between the two arcs is wider than the gap.
[[nodiscard]] bool areApart(const Arc& a, const Arc& b, double gap);

/// Closer than this part of what counts as touching is on a curve, as far as rounding tells.
inline constexpr double kOn = 1.0 / 16;

/// A place where two arcs meet, by the parameters of their segments.
struct Contact {
    double a = 0;
    double b = 0;
    friend constexpr bool operator==(const Contact&, const Contact&) = default;
};

/// How far apart two arcs are at their own parameters.
[[nodiscard]] inline double gapAt(const Arc& a, const Arc& b, Contact contact) {
    return distance(evaluate(a, contact.a).at, evaluate(b, contact.b).at);
}

} // namespace kriva
