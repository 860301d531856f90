#include "core/polynomial/bases.h"
#include "core/polynomial/least_squares.h"
#include "tests/core/polynomial/any_number.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace kriva {
namespace {

/// Points with ascending x, some of them close together.
Points anyPoints(int atLeast, int atMost) {
    Points points;
    double x = *rc::gen::inRange(-1000, 1000);
    const int count = *rc::gen::inRange(atLeast, atMost + 1);
    for (int i = 0; i < count; ++i) {
        points.push_back({x, std::abs(anyNumber(-5, 5))});
        x += std::abs(anyNumber(-12, 2));
    }
    return points;
}

RC_GTEST_PROP(FitLeastSquares, leavesResidualsOrthogonalToAllPowers, ()) {
    const Points points = anyPoints(6, 60);
    const int degree = *rc::gen::inRange(1, 5);
    const Fit fit = fitLeastSquares(points, degree);
    const double low = points.front().x;
    const double width = points.back().x - low;
    for (int power = 0; power <= degree; ++power) {
        double product = 0;
        for (const Point p : points) {
            const BigFloat residual = fit.polynomial.number(p.y) - valueAt(fit.polynomial, p.x);
            product += residual.toDouble() * std::pow((p.x - low) / width, power);
        }
        RC_ASSERT(std::abs(product) < 1e-10);
    }
}

RC_GTEST_PROP(FitLeastSquares, tellsTheErrorsOfItsPolynomial, ()) {
    const Points points = anyPoints(8, 40);
    const Fit fit = fitLeastSquares(points, 3);
    double squares = 0;
    double largest = 0;
    for (const Point p : points) {
        const double residual = (fit.polynomial.number(p.y) - valueAt(fit.polynomial, p.x)).toDouble();
        squares += residual * residual;
        largest = std::max(largest, std::abs(residual));
    }
    RC_ASSERT(std::abs(fit.maxError - largest) <= 1e-12 * largest);
    RC_ASSERT(std::abs(fit.rms - std::sqrt(squares / static_cast<double>(points.size()))) <= 1e-12 * fit.rms);
}

RC_GTEST_PROP(FitLeastSquares, doesNotDependOnTheDirection, ()) {
    Points points = anyPoints(5, 40);
    const Fit forwards = fitLeastSquares(points, 2);
    std::reverse(points.begin(), points.end());
    const Fit backwards = fitLeastSquares(points, 2);
    RC_ASSERT(powerCoefficients(forwards.polynomial) == powerCoefficients(backwards.polynomial));
}

RC_GTEST_PROP(FitLeastSquares, isExactWithAsManyCoefficientsAsPoints, ()) {
    const Points points = anyPoints(1, 8);
    const Fit fit = fitLeastSquares(points, 9);
    RC_ASSERT(fit.polynomial.degree() == static_cast<int>(points.size()) - 1);
    RC_ASSERT(fit.rms == 0);
    RC_ASSERT(fit.maxError == 0);
    for (const Point p : points)
        RC_ASSERT(valueAt(fit.polynomial, p.x).toDouble() == p.y);
}

TEST(FitLeastSquares, findsTheMeanLine) {
    // The normal equations by hand: y = 1/3 + 1/2 x, residuals 1/6, -1/3, 1/6.
    const Fit fit = fitLeastSquares(Points{{0, 0.5}, {1, 0.5}, {2, 1.5}}, 1);
    EXPECT_EQ(powerCoefficients(fit.polynomial), (std::vector<double>{1.0 / 3, 0.5}));
    EXPECT_DOUBLE_EQ(fit.maxError, 1.0 / 3);
    EXPECT_DOUBLE_EQ(fit.rms, std::sqrt(1.0 / 18));
}

TEST(FitLeastSquares, findsAPolynomialFarFromZero) {
    // y = (x - 1e6)^2 with x in steps of 1/1024: in powers of x its coefficients cancel 12 digits of the values.
    Points points;
    for (int i = -500; i <= 500; ++i) {
        const double u = i / 1024.0;
        points.push_back({1e6 + u, u * u});
    }
    const Fit fit = fitLeastSquares(points, 2);
    EXPECT_EQ(powerCoefficients(fit.polynomial), (std::vector<double>{1e12, -2e6, 1}));
    EXPECT_EQ(fit.maxError, 0);
}

TEST(FitLeastSquares, resolvesAClusterBesideFarPoints) {
    // y = 3 + x through 20 points within 1e-9 and two far ones, degree 9.
    Points points{{-1, 2}, {1, 4}};
    for (int i = 1; i <= 20; ++i)
        points.insert(points.end() - 1, {i * 0x1p-34, 3 + i * 0x1p-34});
    const std::vector<double> power = powerCoefficients(fitLeastSquares(points, 9).polynomial);
    EXPECT_EQ(power[0], 3);
    EXPECT_EQ(power[1], 1);
}

TEST(FitLeastSquares, fitsNoMoreThanThePlacesTellApart) {
    // All but one at one place, as far as their span goes: a line through their mean and the last one.
    const Points points{{-100, 7}, {1e-322, 1}, {2e-322, 2}, {3e-322, 3}, {4e-322, 4}};
    const Fit fit = fitLeastSquares(points, 3);
    EXPECT_EQ(fit.polynomial.degree(), 3);
    EXPECT_EQ(valueAt(fit.polynomial, -100).toDouble(), 7);
    EXPECT_NEAR(valueAt(fit.polynomial, 0).toDouble(), 2.5, 1e-15);
    EXPECT_NEAR(valueAt(fit.polynomial, -50).toDouble(), 4.75, 1e-14);
    EXPECT_NEAR(fit.maxError, 1.5, 1e-15);
}

TEST(FitLeastSquares, keepsSmallResiduals) {
    const double tiny = 1e-200;
    const Fit fit = fitLeastSquares(Points{{0, 0}, {1, tiny}, {2, 0}}, 1);
    EXPECT_NEAR(fit.maxError / tiny, 2.0 / 3, 1e-15);
    EXPECT_NEAR(fit.rms / tiny, std::sqrt(2.0) / 3, 1e-15);
}

} // namespace
} // namespace kriva
