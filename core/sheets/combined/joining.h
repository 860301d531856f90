#pragma once

#include "core/polynomial/shape.h"

#include <optional>

namespace kriva {

/// A direction of length 1, wide because a middle point may lie 1e9 times farther than the tangents that meet there
/// differ.
using Tangent = WideVector;

/// The tangent of a graph with this slope, drawn to the right (direction 1) or to the left (-1).
[[nodiscard]] Tangent tangentOf(const DoubleDouble& slope, int direction);

/// One end of a curve that is to be joined to another.
struct CurveEnd {
    double x = 0;
    DoubleDouble y;
    std::optional<Tangent> tangent; ///< along the drawing direction; a single point has none

    [[nodiscard]] Point point() const { return {x, y.high}; }
};

/// A Bézier curve together with its end tangents, which its rounded control points may tell less exactly.
struct TangentPiece {
    Points points;
    Vector startTangent;
    Vector endTangent;
    Points shape; ///< congruent to the points, but not rounded to the distance from the origin
};

/// What joins two neighbouring runs: the quadratic whose middle point is where the two tangents meet, else, where they
/// are parallel or meet behind an end or too far away (format.md, combined), a cubic. A single point has the direction
/// from end to end. The ends are different places.
/// Source: Rossinsky, Kravchenko, Combined algorithm for constructing curves of arbitrary form (2014), (12) and (13).
[[nodiscard]] TangentPiece joinOf(const CurveEnd& from, const CurveEnd& to);

/// What joins two neighbouring points of a run: the quadratic, else two that meet halfway between their middle points.
/// Both ends have tangents.
[[nodiscard]] std::vector<TangentPiece> pairOf(const CurveEnd& from, const CurveEnd& to);

} // namespace kriva
