#pragma once

#include "core/numbers/big_float.h"

#include <span>

namespace kriva {

/// A polynomial y(x) in Newton's form, c_0 + c_1 (x - z_0) + c_2 (x - z_0)(x - z_1) + ..., with coefficients of so
/// many digits that other bases, values and slopes follow from it as exactly as doubles can tell them.
struct Polynomial {
    std::vector<double> nodes;          ///< z_0..z_n, n the degree
    std::vector<BigFloat> coefficients; ///< c_0..c_n
    int digits = 2;                     ///< precision to compute with

    [[nodiscard]] int degree() const { return static_cast<int>(nodes.size()) - 1; }
    [[nodiscard]] BigFloat number(double value) const { return {value, digits}; }
};

/// The polynomial of degree nodes - 1 through the values at the nodes, all different, at least one. O(n^2) operations
/// on numbers of O(n) digits: 201 equispaced nodes take some 20 ms.
/// Source: de Boor, A Practical Guide to Splines, chapter I, (9): c_k = (y_k - p_(k-1)(z_k)) / product of (z_k - z_j).
[[nodiscard]] Polynomial interpolate(std::span<const double> nodes, std::span<const DoubleDouble> values);

/// y(x). O(n).
[[nodiscard]] BigFloat valueAt(const Polynomial& polynomial, double x);

/// The slopes y'(x) at many places that lie among the nodes, in double-double arithmetic, O(n) each; meant for
/// polynomials of fits, whose nodes are ordered so that Newton's form is stable.
[[nodiscard]] std::vector<DoubleDouble> slopesAt(const Polynomial& polynomial, std::span<const double> places);

} // namespace kriva
