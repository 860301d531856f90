#include "core/bezier/evaluate.h"
#include "core/polynomial/bases.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <gmock/gmock.h>

namespace kriva {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;

/// A polynomial of degree 0 to 8 with nodes and values of moderate size.
Polynomial anyPolynomial() {
    std::vector<double> nodes;
    std::vector<DoubleDouble> values;
    const int count = *rc::gen::inRange(1, 10);
    for (int i = 0; i < count; ++i) {
        nodes.push_back(i + *rc::gen::inRange(0, 64) / 128.0 - 4);
        values.emplace_back(*rc::gen::inRange(-100, 100) / 16.0);
    }
    return interpolate(nodes, values);
}

RC_GTEST_PROP(Bases, allTellTheSameValues, ()) {
    const Polynomial polynomial = anyPolynomial();
    const double x = *rc::gen::inRange(-400, 400) / 100.0;
    const double expected = valueAt(polynomial, x).toDouble();
    const double tolerance = 1e-6; // the bases are evaluated in doubles here

    double power = 0;
    const std::vector<double> inPowers = powerCoefficients(polynomial);
    for (std::size_t k = inPowers.size(); k-- > 0;)
        power = power * x + inPowers[k];
    RC_ASSERT(std::abs(power - expected) < tolerance);

    double newton = 0;
    std::vector<double> nodes;
    for (std::size_t k = 0; k < inPowers.size(); ++k)
        nodes.push_back(std::sin(static_cast<double>(k)));
    const std::vector<double> inNewton = newtonCoefficients(polynomial, nodes);
    for (std::size_t k = nodes.size(); k-- > 0;)
        newton = newton * (x - nodes[k]) + inNewton[k];
    RC_ASSERT(std::abs(newton - expected) < tolerance);

    double chebyshev = 0;
    const std::vector<double> inChebyshev = chebyshevCoefficients(polynomial, -4, 4);
    for (std::size_t k = 0; k < inChebyshev.size(); ++k)
        chebyshev += inChebyshev[k] * std::cos(static_cast<double>(k) * std::acos(x / 4));
    RC_ASSERT(std::abs(chebyshev - expected) < tolerance);

    double bezier = 0;
    const std::vector<BigFloat> inBernstein = bernsteinCoefficients(polynomial, 4, -4);
    const std::vector<double> weights = bernstein(polynomial.degree(), (4 - x) / 8);
    for (std::size_t i = 0; i < weights.size(); ++i)
        bezier += inBernstein[i].toDouble() * weights[i];
    RC_ASSERT(std::abs(bezier - expected) < tolerance);
}

TEST(Bases, tellTheParabola) {
    // y = x^2 on [-2, 3]: x = 1/2 + 5/2 u, so y = 27/8 + 5/2 T_1(u) + 25/8 T_2(u).
    const std::vector<double> nodes{-2, -1, 0};
    const std::vector<DoubleDouble> values{4, 1, 0};
    const Polynomial parabola = interpolate(nodes, values);
    EXPECT_THAT(powerCoefficients(parabola), ElementsAre(0, 0, 1));
    EXPECT_THAT(newtonCoefficients(parabola, nodes), ElementsAre(4, -3, 1));
    EXPECT_THAT(lagrangeCoefficients(parabola, chebyshevPoints(2, -2, 3)), ElementsAre(4, 0.25, 9));
    EXPECT_THAT(chebyshevCoefficients(parabola, -2, 3), ElementsAre(3.375, 2.5, 3.125));
}

TEST(Bases, loseNothingAtDegree200) {
    // T_200 from its values, 1 and -1 in turn, at its extrema: coefficients up to 1e75 in powers of x.
    std::vector<double> nodes = chebyshevPoints(200, -1, 1);
    std::vector<DoubleDouble> values;
    for (int i = 0; i <= 200; ++i)
        values.emplace_back(i % 2 == 0 ? 1 : -1);
    const Polynomial polynomial = interpolate(nodes, values);
    const std::vector<double> chebyshev = chebyshevCoefficients(polynomial, -1, 1);
    // The nodes are rounded, hence not 1 and 0; their roundings move the values at the extrema by their squares.
    EXPECT_NEAR(chebyshev[200], 1, 1e-12);
    EXPECT_NEAR(chebyshev[198], 0, 1e-12);
    EXPECT_NEAR(chebyshev[0], 0, 1e-12);
    const std::vector<double> power = powerCoefficients(polynomial);
    EXPECT_NEAR(power[0], 1, 1e-12);
    EXPECT_NEAR(power[200] / 0x1p199, 1, 1e-12);
}

TEST(Bases, tellWhatDoublesCannotHoldAsInfinite) {
    std::vector<double> nodes;
    std::vector<DoubleDouble> values;
    for (int i = 0; i < 60; ++i) {
        nodes.push_back(i * 1e-9);
        values.emplace_back(i % 2);
    }
    const std::vector<double> power = powerCoefficients(interpolate(nodes, values));
    EXPECT_EQ(power[0], 0);
    EXPECT_TRUE(std::isfinite(power[10]));
    EXPECT_TRUE(std::isinf(power[59]));
}

TEST(ChebyshevPoints, areSymmetricAndKeepTheEnds) {
    EXPECT_THAT(chebyshevPoints(1, 2, 5), ElementsAre(2, 5));
    EXPECT_THAT(chebyshevPoints(4, -1, 1), ElementsAre(-1, DoubleEq(-std::sqrt(0.5)), 0, DoubleEq(std::sqrt(0.5)), 1));
}

} // namespace
} // namespace kriva
