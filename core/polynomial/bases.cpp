#include "core/polynomial/bases.h"

#include <numbers>

namespace kriva {
namespace {

std::vector<double> rounded(const std::vector<BigFloat>& numbers) {
    std::vector<double> doubles;
    doubles.reserve(numbers.size());
    for (const BigFloat& number : numbers)
        doubles.push_back(number.toDouble());
    return doubles;
}

/// The coefficients of Newton's form with other centres, as many as the degree (de Boor, A Practical Guide to Splines,
/// chapter I, nested multiplication): after the pass i, c_i is final, and c_(i+1).. are those of the quotient by
/// x - centre_i in the centres z_0, z_1, ..
std::vector<BigFloat> recentred(const Polynomial& polynomial, std::span<const double> centres) {
    std::vector<BigFloat> c = polynomial.coefficients;
    for (std::size_t i = 0; i < centres.size(); ++i) {
        const BigFloat centre = polynomial.number(centres[i]);
        for (std::size_t k = c.size() - 1; k-- > i;)
            c[k] = c[k] + (centre - polynomial.number(polynomial.nodes[k - i])) * c[k + 1];
    }
    return c;
}

} // namespace

std::vector<BigFloat> taylorCoefficients(const Polynomial& polynomial, double at) {
    return recentred(polynomial, std::vector<double>(polynomial.nodes.size() - 1, at));
}

std::vector<BigFloat> bernsteinCoefficients(const Polynomial& polynomial, double from, double to) {
    std::vector<BigFloat> b = taylorCoefficients(polynomial, from);
    const std::size_t n = b.size() - 1;
    const BigFloat width = polynomial.number(to) - polynomial.number(from);
    // The k-th forward difference of b_0 is a_k width^k / C(n, k).
    BigFloat factor = polynomial.number(1);
    for (std::size_t k = 1; k <= n; ++k) {
        const double step = static_cast<double>(k);
        const double rest = static_cast<double>(n - k + 1);
        factor = factor * width * polynomial.number(step) / polynomial.number(rest);
        b[k] = b[k] * factor;
    }
    for (std::size_t round = 1; round <= n; ++round)
        for (std::size_t i = n; i >= round; --i)
            b[i] = b[i] + b[i - 1];
    return b;
}

std::vector<double> powerCoefficients(const Polynomial& polynomial) {
    return rounded(taylorCoefficients(polynomial, 0));
}

std::vector<double> newtonCoefficients(const Polynomial& polynomial, std::span<const double> nodes) {
    return rounded(recentred(polynomial, nodes.first(nodes.size() - 1)));
}

std::vector<double> lagrangeCoefficients(const Polynomial& polynomial, std::span<const double> nodes) {
    std::vector<double> values;
    values.reserve(nodes.size());
    for (const double x : nodes)
        values.push_back(valueAt(polynomial, x).toDouble());
    return values;
}

std::vector<double> chebyshevCoefficients(const Polynomial& polynomial, double low, double high) {
    const BigFloat middle = (polynomial.number(low) + polynomial.number(high)).half();
    const BigFloat quarter = (polynomial.number(high) - polynomial.number(low)).half().half();
    std::vector<BigFloat> c;
    for (std::size_t k = polynomial.nodes.size(); k-- > 0;) {
        // Horner's scheme: x - z_k = (middle - z_k) + 2 quarter u, and 2 u T_j = T_(j+1) + T_|j-1|.
        const BigFloat distance = middle - polynomial.number(polynomial.nodes[k]);
        std::vector<BigFloat> next(c.size() + 1);
        for (std::size_t j = 0; j < c.size(); ++j) {
            const BigFloat part = quarter * c[j];
            next[j] = next[j] + distance * c[j];
            next[j + 1] = next[j + 1] + part + (j == 0 ? part : BigFloat());
            if (j > 0)
                next[j - 1] = next[j - 1] + part;
        }
        next[0] = next[0] + polynomial.coefficients[k];
        c = std::move(next);
    }
    return rounded(c);
}

std::vector<double> chebyshevPoints(int degree, double low, double high) {
    std::vector<double> points;
    for (int j = 0; j <= degree; ++j) {
        // sin instead of cos: the points come out symmetric about the middle.
        const double u = std::sin(std::numbers::pi * (2 * j - degree) / (2 * degree));
        points.push_back(low / 2 + high / 2 + (high / 2 - low / 2) * u);
    }
    points.front() = low;
    points.back() = high;
    return points;
}

} // namespace kriva
