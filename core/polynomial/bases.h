#pragma once

#include "core/polynomial/polynomial.h"

/// One polynomial y(x) in other bases. Coefficients beyond the range of doubles come back infinite. Each O(n^2)
/// operations on numbers of O(n) digits.
namespace kriva {

/// a_0..a_n with y = sum of a_k (x - at)^k.
[[nodiscard]] std::vector<BigFloat> taylorCoefficients(const Polynomial& polynomial, double at);

/// b_0..b_n with y = sum of b_i B_i(t), B_i the Bernstein polynomials of degree n and x = from + t (to - from).
/// Source: Farin, Curves and Surfaces for CAGD, 5th ed., section 5.8, through the forward differences of the b_i.
[[nodiscard]] std::vector<BigFloat> bernsteinCoefficients(const Polynomial& polynomial, double from, double to);

/// c_0..c_n with y = sum of c_k x^k.
[[nodiscard]] std::vector<double> powerCoefficients(const Polynomial& polynomial);

/// c_0..c_n with y = c_0 + c_1 (x - z_0) + c_2 (x - z_0)(x - z_1) + ... for the nodes z_0..z_n.
[[nodiscard]] std::vector<double> newtonCoefficients(const Polynomial& polynomial, std::span<const double> nodes);

/// The values y at the nodes: the coefficients in the Lagrange basis of these nodes.
[[nodiscard]] std::vector<double> lagrangeCoefficients(const Polynomial& polynomial, std::span<const double> nodes);

/// c_0..c_n with y = sum of c_k T_k(u), T_k the Chebyshev polynomials and u = -1 at low, 1 at high; low < high.
/// Source: Mason, Handscomb, Chebyshev Polynomials, section 2.4.
[[nodiscard]] std::vector<double> chebyshevCoefficients(const Polynomial& polynomial, double low, double high);

/// The degree + 1 Chebyshev points of the second kind over [low, high], ascending, both ends exact; degree >= 1.
[[nodiscard]] std::vector<double> chebyshevPoints(int degree, double low, double high);

} // namespace kriva
