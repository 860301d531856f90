#pragma once

#include "core/geometry/point.h"
#include "core/numbers/double_double.h"

namespace kriva {

/// A vector in double-double arithmetic.
struct WideVector {
    DoubleDouble x;
    DoubleDouble y;

    [[nodiscard]] Vector vector() const { return {x.high, y.high}; }
    friend WideVector operator+(const WideVector& a, const WideVector& b) { return {a.x + b.x, a.y + b.y}; }
    friend WideVector operator-(const WideVector& a, const WideVector& b) { return {a.x - b.x, a.y - b.y}; }
    friend WideVector operator*(const DoubleDouble& s, const WideVector& a) { return {s * a.x, s * a.y}; }
};

/// The control points of a curve, given as vectors from its start, in a frame of its own: the start is the origin, and
/// the end lies ahead. So the points keep all digits of what bends the curve, however far from the origin and however
/// straight it is.
[[nodiscard]] Points shapeOf(std::span<const WideVector> fromStart);

} // namespace kriva
