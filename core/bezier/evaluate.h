#pragma once

#include "core/geometry/point.h"

/// Values of one polynomial Bézier curve of any degree, given by its control points b_0..b_n (n >= 0).
namespace kriva {

/// The point at t, by de Casteljau's scheme: n (n + 1) / 2 linear interpolations, exact at t = 0 and 1.
/// Source: Farin, Curves and Surfaces for CAGD, 5th ed., section 4.2.
[[nodiscard]] Point evaluate(std::span<const Point> curve, double t);

/// The points at many parameters, as many as `points` has room for: up to degree 5 to the last bit those of evaluate(),
/// above each within 4 n roundings of the polygon's size, exact at 0 and 1 too. In O(n) each, four at a time.
void evaluate(std::span<const Point> curve, std::span<const double> ts, std::span<Point> points);

/// The first derivative by t; {0, 0} for a curve of degree 0.
[[nodiscard]] Vector derivative(std::span<const Point> curve, double t);

/// The second derivative by t; {0, 0} below degree 2.
[[nodiscard]] Vector secondDerivative(std::span<const Point> curve, double t);

/// The control vectors n (b_(i+1) - b_i) of the derivative, a Bézier curve of degree n - 1; empty for degree 0.
[[nodiscard]] std::vector<Vector> hodograph(std::span<const Point> curve);

/// The Bernstein polynomials B_0..B_degree at t, all non-negative on [0, 1], their sum 1. O(degree^2).
[[nodiscard]] std::vector<double> bernstein(int degree, double t);

} // namespace kriva
