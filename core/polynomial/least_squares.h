#pragma once

#include "core/geometry/point.h"
#include "core/polynomial/polynomial.h"

namespace kriva {

/// A polynomial y(x) near given points.
struct Fit {
    Polynomial polynomial;
    double rms = 0;      ///< root of the mean of the squared residuals
    double maxError = 0; ///< the largest residual, without its sign
};

/// The polynomial of degree points - 1 through all points, whose x must differ; both errors are 0.
[[nodiscard]] Fit fitThroughAll(std::span<const Point> points);

/// The polynomial of at most the degree with the least sum of squared residuals; through all points where there are
/// no more than degree + 1. Their x must differ. O(points degree^2): 100,000 points and degree 9 take some 0.2 s.
/// The basis is made orthogonal over the points themselves, as in Forsythe's method but against all members before
/// it, in double-double arithmetic, so that even points in clusters leave it orthogonal. Where their x lie closer
/// together than 1e-27 of their span, only the coefficients that they tell apart are fitted, and the others are 0.
/// Residuals below 1e-27 of the largest value count as 0.
/// Sources: Forsythe, Generation and use of orthogonal polynomials, J. SIAM 5 (1957); Brubeck, Nakatsukasa,
/// Trefethen, Vandermonde with Arnoldi, SIAM Review 63 (2021).
[[nodiscard]] Fit fitLeastSquares(std::span<const Point> points, int degree);

} // namespace kriva
