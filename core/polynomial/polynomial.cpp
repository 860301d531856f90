#include "core/polynomial/polynomial.h"

#include <algorithm>
#include <cassert>

namespace kriva {
namespace {

/// How many bits the largest weight 1 / |product over i != j of (z_j - z_i)| has when the nodes span [-1, 1]: so many
/// may cancel between the coefficients of Newton's form and the values of the polynomial.
double bitsOfWeights(std::span<const double> nodes) {
    const auto [low, high] = std::minmax_element(nodes.begin(), nodes.end());
    const double halfSpan = *high / 2 - *low / 2;
    double most = 0;
    for (const double z : nodes) {
        double bits = 0;
        for (const double other : nodes)
            bits -= other == z ? 0 : std::log2(std::abs(z - other) / halfSpan);
        most = std::max(most, bits);
    }
    return most;
}

int digitsFor(std::span<const double> nodes) {
    constexpr double kOfResult = 192; // a double-double's 106 bits, and a digit that truncation may leave half empty
    constexpr double kPerDegree = 6;  // a change of basis over [-1, 1] grows by no more than (1 + sqrt 2)^n, twice
    constexpr double kMostOfWeights = 4096; // nodes a rounding apart, dozens of them: their values say nothing more
    const double ofWeights = std::min(bitsOfWeights(nodes), kMostOfWeights);
    // Forward substitution meets the weights a second time (Higham, Accuracy and Stability, section 8.2).
    return static_cast<int>((kOfResult + kPerDegree * static_cast<double>(nodes.size()) + 2 * ofWeights) / 64) + 1;
}

} // namespace

Polynomial interpolate(std::span<const double> nodes, std::span<const DoubleDouble> values) {
    assert(!nodes.empty() && nodes.size() == values.size());
    Polynomial result{{nodes.begin(), nodes.end()}, {}, digitsFor(nodes)};
    result.coefficients.reserve(nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const BigFloat place = result.number(nodes[k]);
        BigFloat value;
        BigFloat product = result.number(1);
        for (std::size_t j = 0; j < k; ++j) {
            value = value + result.coefficients[j] * product;
            product = product * (place - result.number(nodes[j]));
        }
        result.coefficients.push_back((BigFloat(values[k], result.digits) - value) / product);
    }
    return result;
}

BigFloat valueAt(const Polynomial& polynomial, double x) {
    const BigFloat place = polynomial.number(x);
    BigFloat value;
    for (std::size_t k = polynomial.nodes.size(); k-- > 0;)
        value = value * (place - polynomial.number(polynomial.nodes[k])) + polynomial.coefficients[k];
    return value;
}

std::vector<DoubleDouble> slopesAt(const Polynomial& polynomial, std::span<const double> places) {
    const auto [low, high] = std::minmax_element(polynomial.nodes.begin(), polynomial.nodes.end());
    const double unit = std::exp2(std::ceil(std::log2(*high - *low))); // a power of two: dividing by it is exact
    std::vector<DoubleDouble> scaled;
    BigFloat power = polynomial.number(1);
    for (const BigFloat& coefficient : polynomial.coefficients) {
        scaled.push_back((coefficient * power).toDoubleDouble());
        power = power * polynomial.number(unit);
    }
    std::vector<DoubleDouble> slopes;
    slopes.reserve(places.size());
    for (const double x : places) {
        DoubleDouble value = 0;
        DoubleDouble slope = 0;
        for (std::size_t k = scaled.size(); k-- > 0;) {
            const DoubleDouble distance = exactSum(x, -polynomial.nodes[k]);
            const DoubleDouble factor(distance.high / unit, distance.low / unit);
            slope = slope * factor + value;
            value = value * factor + scaled[k];
        }
        slopes.push_back(slope / unit);
    }
    return slopes;
}

} // namespace kriva
