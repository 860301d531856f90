#pragma once

#include "core/polynomial/polynomial.h"
#include "core/polynomial/shape.h"

namespace kriva {

/// The graph of a polynomial y(x) from one x to another, which may lie to the left.
struct Graph {
    Points curve;               ///< as a Bézier curve of its degree, control points equally spaced in x
    std::vector<Points> parts;  ///< the same curve, cut where doubles cannot tell it by the control points of the whole
    std::vector<Points> shapes; ///< of the parts, see shapeOf()
    DoubleDouble startValue;    ///< y at the first x
    DoubleDouble endValue;
    DoubleDouble startSlope; ///< y' by x there, whatever the direction
    DoubleDouble endSlope;
    double slopeVariation = 0; ///< integral of |y''| over the x between, 1e-11 relative
};

/// The x must differ; the degree is at least 1. Coordinates beyond the range of doubles come back infinite.
[[nodiscard]] Graph graphOf(const Polynomial& polynomial, double from, double to);

} // namespace kriva
