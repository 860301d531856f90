#include "core/polynomial/bernstein_polynomial.h"
#include "core/polynomial/casteljau.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

double valueAt(std::vector<double> coefficients, double t) {
    return valueInPlace(std::span(coefficients), t);
}

rc::Gen<std::vector<double>> anyCoefficients() {
    return rc::gen::mapcat(rc::gen::inRange<std::size_t>(1, 12), [](std::size_t size) {
        return rc::gen::container<std::vector<double>>(
            size, rc::gen::map(rc::gen::inRange(-1000, 1001), [](int i) { return i / 16.0; }));
    });
}

TEST(Binomials, areThoseOfPascal) {
    EXPECT_EQ(binomials(0), (std::vector<double>{1}));
    EXPECT_EQ(binomials(5), (std::vector<double>{1, 5, 10, 10, 5, 1}));
    // C(200, 100), from its prime factors.
    EXPECT_NEAR(binomials(200)[100] / 9.0548514656103281e58, 1, 1e-14);
}

RC_GTEST_PROP(Product, hasTheProductOfTheValues, ()) {
    const auto a = *anyCoefficients();
    const auto b = *anyCoefficients();
    const double t = *rc::gen::element(0.0, 0.3, 0.5, 1.0);
    RC_ASSERT(std::abs(valueAt(product(a, b), t) - valueAt(a, t) * valueAt(b, t)) <= 1e-10);
}

TEST(Product, staysFiniteAtTheDegreesOfCurves) {
    const std::vector<double> ones(400, 1.0);
    for (const double c : product(ones, ones))
        EXPECT_NEAR(c, 1, 1e-12);
}

TEST(Product, inDoubleDoubleKeepsThirtyDigits) {
    const std::vector<DoubleDouble> third(61, DoubleDouble(1.0) / DoubleDouble(3.0));
    for (const DoubleDouble c : product(third, third))
        EXPECT_NEAR(static_cast<double>(c * DoubleDouble(9.0) - DoubleDouble(1.0)), 0, 1e-28);
}

RC_GTEST_PROP(Differentiated, isTheSlope, ()) {
    const auto a = *anyCoefficients();
    const double step = 1e-5;
    const double slope = (valueAt(a, 0.4 + step) - valueAt(a, 0.4 - step)) / (2 * step);
    RC_ASSERT(std::abs(valueAt(differentiated(a), 0.4) - slope) <= 1e-3);
}

TEST(Differentiated, ofAConstantIsZero) {
    EXPECT_EQ(differentiated(std::vector<double>{5}), std::vector<double>{0});
}

TEST(RangeOf, seesExtremesInsideAndAtTheEnds) {
    EXPECT_EQ(rangeOf(std::vector<double>{2}), (Range{2, 2}));
    EXPECT_EQ(rangeOf(std::vector<double>{2, -1}), (Range{-1, 2}));
    EXPECT_EQ(rangeOf(std::vector<double>{0, 1, 0}), (Range{0, 0.5}));
}

RC_GTEST_PROP(RangeOf, holdsAllValues, ()) {
    const auto a = *anyCoefficients();
    const Range range = rangeOf(a);
    for (int i = 0; i <= 100; ++i) {
        const double value = valueAt(a, i / 100.0);
        RC_ASSERT(range.low - 1e-12 <= value && value <= range.high + 1e-12);
    }
}

TEST(LargestCoefficient, looksAtSizesAlone) {
    EXPECT_EQ(largestCoefficient(std::vector<double>{1, -3, 2}), 3);
    EXPECT_EQ(largestCoefficient(std::vector<DoubleDouble>{1.0, -3.0, 2.0}), 3);
}

} // namespace
} // namespace kriva
