#pragma once

#include "core/sheets/combined/combined_curve.h"
#include "core/sheets/combined/joining.h"
#include "core/sheets/combined/monotone_runs.h"

namespace kriva {

/// What became of one run of points.
struct CombinedRun {
    MonotoneRun points;
    int degree = 0;                   ///< of its polynomial; 0 for one point
    std::vector<double> nodes;        ///< of the Newton and Lagrange bases
    std::vector<double> coefficients; ///< c_0 first, in the basis asked for
    double rms = 0;                   ///< of the residuals
    double maxError = 0;              ///< the largest residual
    CurveEnd start;                   ///< where its part of the path starts; without a tangent for one point
    CurveEnd end;
    std::optional<double> startSlope; ///< of its polynomial, by x
    std::optional<double> endSlope;
    double slopeVariation = 0;      ///< integral of |y''| of its polynomial
    Points graph;                   ///< its polynomial as a Bézier curve, in drawing direction; empty for one point
    std::vector<Points> parts;      ///< the graph, cut where doubles cannot tell it by the control points of the whole
    std::vector<Points> shapes;     ///< of the parts, see shapeOf()
    std::vector<CurveEnd> pairEnds; ///< under Method::pairs each of its points, with the tangent of the polynomial
};

/// Fits the polynomial of one run of the curve's points.
[[nodiscard]] CombinedRun fitRun(const CombinedCurve& curve, const MonotoneRun& points);

} // namespace kriva
