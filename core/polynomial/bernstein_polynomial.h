#pragma once

#include "core/numbers/double_double.h"
#include "core/polynomial/long_rows.h"

#include <array>
#include <span>
#include <type_traits>
#include <vector>

/// Polynomials over [0, 1], given by their Bernstein coefficients: never empty, one more than the formal degree.
namespace kriva {

/// base^exponent by repeated squaring.
[[nodiscard]] constexpr double power(double base, std::size_t exponent) {
    double result = 1;
    for (; exponent > 0; exponent /= 2, base *= base)
        result *= exponent % 2 == 1 ? base : 1;
    return result;
}

/// The binomial coefficients C(degree, 0)..C(degree, degree), a few ulp.
[[nodiscard]] std::vector<double> binomials(std::size_t degree);

/// Multiplies coefficient i by C(degree, i), which makes values cost O(degree) instead of O(degree^2).
template <class Row>
constexpr void scaleByBinomials(Row&& row) {
    const std::size_t degree = row.size() - 1;
    double binomial = 1;
    for (std::size_t i = 0; i <= degree; ++i) {
        row[i] = binomial * row[i];
        binomial = binomial * static_cast<double>(degree - i) / static_cast<double>(i + 1);
    }
}

/// Two values of a polynomial.
template <class T>
struct MirroredValues {
    T near; ///< at t
    T far;  ///< at 1 - t
};

/// The values at t <= 1/2 and at its mirror image, as (1 - t)^degree times polynomials in t / (1 - t): no term is
/// larger than in de Casteljau's scheme. `scaled` by binomials.
template <class T>
[[nodiscard]] constexpr MirroredValues<T> mirroredValues(std::span<const T> scaled, double t) {
    const std::size_t degree = scaled.size() - 1;
    const double ratio = t / (1 - t);
    MirroredValues<T> values{scaled[degree], scaled[0]};
    for (std::size_t i = 1; i <= degree; ++i) {
        values.near = ratio * values.near + scaled[degree - i];
        values.far = ratio * values.far + scaled[i];
    }
    const double factor = power(1 - t, degree);
    return {factor * values.near, factor * values.far};
}

/// The same at several t, to the last bit, in less time: each step of one of them waits for the step before it, and
/// meanwhile the others go on.
template <std::size_t count, class T>
[[nodiscard]] constexpr std::array<MirroredValues<T>, count> mirroredValues(std::span<const T> scaled,
                                                                            const std::array<double, count>& ts) {
    const std::size_t degree = scaled.size() - 1;
    std::array<double, count> ratios{};
    for (std::size_t k = 0; k < count; ++k)
        ratios[k] = ts[k] / (1 - ts[k]);
    std::array<T, count> near;
    std::array<T, count> far;
    if constexpr (count == kTogetherInLongRow && std::is_same_v<T, Vector>) {
        evaluateLongRow(scaled, ratios, near, far);
    } else {
        near.fill(scaled[degree]);
        far.fill(scaled[0]);
        for (std::size_t i = 1; i <= degree; ++i)
            for (std::size_t k = 0; k < count; ++k) {
                near[k] = ratios[k] * near[k] + scaled[degree - i];
                far[k] = ratios[k] * far[k] + scaled[i];
            }
    }
    std::array<MirroredValues<T>, count> values{};
    for (std::size_t k = 0; k < count; ++k) {
        const double factor = power(1 - ts[k], degree);
        values[k] = {factor * near[k], factor * far[k]};
    }
    return values;
}

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
