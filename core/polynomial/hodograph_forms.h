#pragma once

#include "core/geometry/point.h"
#include "core/numbers/double_double.h"

/// Polynomials made of a curve's derivative c(t): what speed and curvature are made of.
namespace kriva {

/// The components of c, or of a part of it, by their Bernstein coefficients, at least one; T is double or DoubleDouble.
template <class T>
struct Hodograph {
    std::vector<T> x;
    std::vector<T> y;
};

/// A power of two, not above the largest component of the control polygon's sides, that keeps products within the
/// range of doubles; 1 where all control points coincide.
[[nodiscard]] double unitOf(std::span<const Point> curve);

/// The derivative of a curve of degree 1 or more, divided by `unit`; in double-double as exact as the control points.
template <class T>
[[nodiscard]] Hodograph<T> hodographIn(double unit, std::span<const Point> curve);

/// c x c', whose sign is that of the curvature: the degree is twice that of c less 2; a single 0 where c is constant.
template <class T>
[[nodiscard]] std::vector<T> turning(const Hodograph<T>& hodograph);

/// |c|^2.
template <class T>
[[nodiscard]] std::vector<T> speedSquared(const Hodograph<T>& hodograph);

/// The length of a vector whose square neither overflows nor vanishes.
[[nodiscard]] inline double size(Vector v) {
    return std::sqrt(dot(v, v));
}

/// A derivative as a line plus a rest: sizes of the middle of the line, of its half, of the largest Bernstein
/// coefficient of the rest. For complex t with |t| + |1 - t| <= s, inside a Bernstein ellipse around [0, 1], the
/// derivative is within s half + s^degree rest of the middle.
struct Spread {
    double middle = 0;
    double half = 0;
    double rest = 0;
};

[[nodiscard]] Spread spreadOf(std::span<const Vector> hodograph);

} // namespace kriva
