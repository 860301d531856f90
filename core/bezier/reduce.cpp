#include "core/bezier/reduce.h"

#include "core/polynomial/bernstein_polynomial.h"

#include <algorithm>
#include <cassert>

namespace kriva {

namespace {

/// The Bernstein coefficients, degree n >= 2, of t (1 - t) J(t), the largest of them of size 1.
std::vector<double> leastPolynomial(std::size_t n) {
    const std::size_t k = n - 2;
    const std::vector<double> outer = binomials(k + 2);
    const std::vector<double> inner = binomials(k);
    // J has the coefficients (-1)^(k - i) C(k + 2, i) C(k + 2, k - i) / C(k, i).
    std::vector<double> jacobi;
    for (std::size_t i = 0; i <= k; ++i)
        jacobi.push_back(((k - i) % 2 == 0 ? 1 : -1) * (outer[i] / inner[i]) * outer[k - i]);
    std::vector<double> result = product(jacobi, std::vector<double>{0, 0.5, 0});
    const double largest = largestCoefficient(result);
    for (double& c : result)
        c /= largest;
    return result;
}

/// The n-th difference of Bernstein coefficients, each alternate one with the other sign, divided by C(n, n / 2): up to
/// that factor the leading coefficient of the polynomial.
template <class T>
T leading(std::span<const T> coefficients) {
    const std::size_t n = coefficients.size() - 1;
    const std::vector<double> binomial = binomials(n);
    T sum{};
    for (std::size_t i = 0; i <= n; ++i)
        sum = sum + ((n - i) % 2 == 0 ? 1 : -1) * (binomial[i] / binomial[n / 2]) * coefficients[i];
    return sum;
}

/// The control vectors of one degree less, where there are such. Each elevated one is a mean of two of these: solved
/// from the nearer end, where the recurrence damps errors.
/// Source: Forrest, Interactive interpolation and approximation by Bezier polynomials, Comp. J. 15 (1972).
std::vector<Vector> lowered(std::span<const Vector> raised) {
    const std::size_t n = raised.size() - 1;
    std::vector<Vector> result(n);
    const auto size = static_cast<double>(n);
    result.front() = raised.front();
    result.back() = raised.back();
    for (std::size_t i = 1; i <= (n - 1) / 2; ++i) {
        const auto left = static_cast<double>(i);
        result[i] = (size * raised[i] - left * result[i - 1]) / (size - left);
    }
    for (std::size_t i = n - 1; i > (n - 1) / 2 + 1; --i) {
        const auto left = static_cast<double>(i);
        result[i - 1] = (size * raised[i] - (size - left) * result[i]) / left;
    }
    return result;
}

} // namespace

std::optional<Reduction> reduced(std::span<const Point> curve) {
    assert(!curve.empty());
    if (curve.size() < 3)
        return std::nullopt;
    std::vector<Vector> vectors;
    for (const Point p : curve)
        vectors.push_back(p - curve.front());
    const std::vector<double> least = leastPolynomial(curve.size() - 1);
    const Vector factor = leading(std::span<const Vector>(vectors)) / leading(std::span(least));
    for (std::size_t i = 0; i < vectors.size(); ++i)
        vectors[i] = vectors[i] - least[i] * factor;

    Reduction result;
    for (const Vector v : lowered(vectors))
        result.points.push_back(curve.front() + v);
    result.points.back() = curve.back();
    const Range range = rangeOf(least);
    result.maxDeviation = length(factor) * std::max(-range.low, range.high);
    return result;
}

} // namespace kriva
