#include "core/polynomial/bernstein_polynomial.h"

#include "core/polynomial/casteljau.h"
#include "core/polynomial/sign_changes.h"

#include <algorithm>
#include <cassert>

namespace kriva {

namespace {

template <class T>
double largestOf(std::span<const T> coefficients) {
    double largest = 0;
    for (const T& c : coefficients)
        largest = std::max(largest, std::abs(static_cast<double>(c)));
    return largest;
}

template <class T>
std::vector<T> derivativeOf(std::span<const T> coefficients) {
    const T degree(static_cast<double>(coefficients.size() - 1));
    std::vector<T> result;
    for (std::size_t i = 0; i + 1 < coefficients.size(); ++i)
        result.push_back(degree * (coefficients[i + 1] - coefficients[i]));
    if (result.empty())
        result.emplace_back(0.0);
    return result;
}

template <class T>
std::vector<T> binomialsOf(std::size_t degree) {
    std::vector<T> row(degree + 1, T(1.0));
    // Symmetric, so the rounding of the recurrence runs over one half only.
    for (std::size_t i = 1; i <= degree / 2; ++i)
        row[i] = row[degree - i] = row[i - 1] * T(static_cast<double>(degree + 1 - i)) / T(static_cast<double>(i));
    return row;
}

/// a_i C(n, i): products of such scaled coefficients only add up.
template <class T>
std::vector<T> scaled(std::span<const T> coefficients) {
    const std::vector<T> binomial = binomialsOf<T>(coefficients.size() - 1);
    std::vector<T> result(coefficients.begin(), coefficients.end());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = result[i] * binomial[i];
    return result;
}

template <class T>
std::vector<T> productOf(std::span<const T> a, std::span<const T> b) {
    assert(!a.empty() && !b.empty());
    const std::vector<T> left = scaled(a);
    const std::vector<T> right = scaled(b);
    std::vector<T> result(a.size() + b.size() - 1, T(0.0));
    for (std::size_t i = 0; i < left.size(); ++i)
        for (std::size_t j = 0; j < right.size(); ++j)
            result[i + j] = result[i + j] + left[i] * right[j];
    const std::vector<T> binomial = binomialsOf<T>(result.size() - 1);
    for (std::size_t k = 0; k < result.size(); ++k)
        result[k] = result[k] / binomial[k];
    return result;
}

} // namespace

std::vector<double> binomials(std::size_t degree) {
    return binomialsOf<double>(degree);
}

double largestCoefficient(std::span<const double> coefficients) {
    return largestOf(coefficients);
}

double largestCoefficient(std::span<const DoubleDouble> coefficients) {
    return largestOf(coefficients);
}

std::vector<double> differentiated(std::span<const double> coefficients) {
    return derivativeOf(coefficients);
}

std::vector<DoubleDouble> differentiated(std::span<const DoubleDouble> coefficients) {
    return derivativeOf(coefficients);
}

std::vector<double> product(std::span<const double> a, std::span<const double> b) {
    return productOf(a, b);
}

std::vector<DoubleDouble> product(std::span<const DoubleDouble> a, std::span<const DoubleDouble> b) {
    return productOf(a, b);
}

Range rangeOf(std::span<const double> coefficients) {
    assert(!coefficients.empty());
    const auto [least, most] = std::minmax({coefficients.front(), coefficients.back()});
    Range range{least, most};
    // A polynomial lies between its coefficients: most pieces of a spline end here.
    if (std::ranges::all_of(coefficients, [&](double c) { return range.low <= c && c <= range.high; }))
        return range;
    RowBuffer<double> buffer(coefficients.size());
    const std::span<double> steps = buffer.row().first(coefficients.size() - 1);
    for (std::size_t i = 0; i < steps.size(); ++i)
        steps[i] = coefficients[i + 1] - coefficients[i];
    for (const double t : signChanges(steps)) {
        std::ranges::copy(coefficients, buffer.row().begin());
        const double value = valueInPlace(buffer.row(), t);
        range = {std::min(range.low, value), std::max(range.high, value)};
    }
    return range;
}

} // namespace kriva
