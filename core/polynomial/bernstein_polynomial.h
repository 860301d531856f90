#pragma once

#include "core/polynomial/double_double.h"

#include <span>
#include <vector>

/// Polynomials over [0, 1], given by their Bernstein coefficients: never empty, one more than the formal degree.
namespace kriva {

/// The binomial coefficients C(degree, 0)..C(degree, degree), a few ulp.
[[nodiscard]] std::vector<double> binomials(std::size_t degree);

/// The largest absolute value of a coefficient, which no value on [0, 1] exceeds.
[[nodiscard]] double largestCoefficient(std::span<const double> coefficients);
[[nodiscard]] double largestCoefficient(std::span<const DoubleDouble> coefficients);

/// The coefficients of the derivative; a single 0 for degree 0.
[[nodiscard]] std::vector<double> differentiated(std::span<const double> coefficients);
[[nodiscard]] std::vector<DoubleDouble> differentiated(std::span<const DoubleDouble> coefficients);

/// The coefficients of the product, O(degree * degree), each within a few ulp of the largest. For degrees up to 1000 in
/// sum, where binomial coefficients reach the end of doubles, and coefficients of about 1 where they come near it.
/// Source: Farouki, Rajan, Algorithms for polynomials in Bernstein form, CAGD 5 (1988), formula (44).
[[nodiscard]] std::vector<double> product(std::span<const double> a, std::span<const double> b);
[[nodiscard]] std::vector<DoubleDouble> product(std::span<const DoubleDouble> a, std::span<const DoubleDouble> b);

/// The least and the greatest value on an interval.
struct Range {
    double low = 0;
    double high = 0;
    friend constexpr bool operator==(const Range&, const Range&) = default;
};

/// The range on [0, 1], ends included, a few ulp of the largest coefficient.
[[nodiscard]] Range rangeOf(std::span<const double> coefficients);

} // namespace kriva
