#include "core/sheets/combined/path_measures.h"

#include <gtest/gtest.h>

#include <numbers>

namespace kriva {
namespace {

using Method = CombinedCurve::Method;

CombinedCurve pathThrough(Points points, Method method = Method::approximation, int degree = 3) {
    CombinedCurve curve;
    curve.points = std::move(points);
    curve.method = method;
    curve.degree = degree;
    return curve;
}

PathMeasures measured(const CombinedCurve& curve) {
    return measure(combine(curve), curve.points);
}

const Points kSampledParabola{{-2, 4}, {-1, 1}, {0, 0}, {1, 1}, {2, 4}, {3, 9}};

TEST(Measure, knowsTheParabola) {
    // y = x^2 from -2 to 3: length (x sqrt(1 + 4 x^2) / 2 + asinh(2 x) / 4), energy 4 times the integral of
    // (1 + 4 x^2)^(-5/2), slope from -4 to 6.
    const auto length = [](double x) { return x * std::sqrt(1 + 4 * x * x) / 2 + std::asinh(2 * x) / 4; };
    const auto energy = [](double x) {
        const double u = 2 * x / std::sqrt(1 + 4 * x * x);
        return 2 * (u - u * u * u / 3);
    };
    for (const Method method : {Method::approximation, Method::interpolation, Method::pairs}) {
        PathMeasures measures = measured(pathThrough(kSampledParabola, method, 2));
        EXPECT_NEAR(measures.length, length(3) - length(-2), 1e-12);
        EXPECT_NEAR(measures.bounds.ymin, 0, 1e-14);
        measures.bounds.ymin = 0;
        EXPECT_EQ(measures.bounds, (Box{-2, 0, 3, 9}));
        EXPECT_NEAR(measures.largestKink, 0, 1e-15);
        ASSERT_TRUE(measures.bendingEnergy);
        EXPECT_NEAR(*measures.bendingEnergy, energy(3) - energy(-2), 1e-9);
        EXPECT_NEAR(measures.slopeVariation, 10, 1e-10);
    }
}

TEST(Measure, seesTheKinkOfACorrection) {
    // The tangents of the pair from (0, 0) to (1, 1) over (1/2, -1) have slopes -2 and 4 instead of 0 and 2.
    CombinedCurve curve = pathThrough(kSampledParabola, Method::pairs, 2);
    curve.corrections[2] = {0.5, -1};
    EXPECT_NEAR(measured(curve).largestKink, std::atan(2.0), 1e-15);
    EXPECT_NEAR(measured(curve).bounds.ymin, -1.0 / 3, 1e-15);
}

TEST(Measure, countsTheTurnWhereRunsMeet) {
    // Up to (1, 1) and, from the same place, back to (0, 1): no join, a turn of 135 degrees.
    const PathMeasures measures = measured(pathThrough({{0, 0}, {1, 1}, {1, 1}, {0, 1}}));
    EXPECT_NEAR(measures.largestKink, 3 * std::numbers::pi / 4, 1e-15);
    EXPECT_NEAR(measures.length, 1 + std::sqrt(2.0), 1e-15);
    EXPECT_EQ(measures.bendingEnergy, 0);
}

TEST(Measure, isThatOfThePointsWithoutAPiece) {
    const PathMeasures measures = measured(pathThrough({{3, 4}}));
    EXPECT_EQ(measures.length, 0);
    EXPECT_EQ(measures.bounds, (Box{3, 4, 3, 4}));
    EXPECT_EQ(measures.largestKink, 0);
    EXPECT_EQ(measures.bendingEnergy, 0);
    EXPECT_EQ(measures.slopeVariation, 0);
}

TEST(Measure, takesHighDegreesInParts) {
    // Runge's function at 101 Chebyshev points: as a Bézier curve its control points exceed 1e9, its values 1 never.
    CombinedCurve curve = pathThrough({}, Method::interpolation);
    for (int i = 0; i <= 100; ++i) {
        const double x = -std::cos(i * std::numbers::pi / 100);
        curve.points.push_back({x, 1 / (1 + 25 * x * x)});
    }
    const PathMeasures measures = measured(curve);
    // The length of Runge's function itself, from Simpson's rule with 1e6 intervals.
    EXPECT_NEAR(measures.length, 3.0838518887841655, 1e-6);
    EXPECT_NEAR(measures.bounds.ymin, 1.0 / 26, 1e-12);
    EXPECT_NEAR(measures.bounds.ymax, 1, 1e-7);
}

TEST(Measure, isTheSameFarFromTheOrigin) {
    // Runs to the right, to the left and of one point; corrected, joined by quadratics and by cubics.
    const Points points{{0, 0}, {1, 2}, {2, 1}, {3, 1.5}, {2.5, 4}, {1, 5}, {-1, 4.5}, {-1, 6}, {0, 7}, {2, 7.25}};
    for (const Method method : {Method::approximation, Method::interpolation, Method::pairs}) {
        const CombinedCurve near = pathThrough(points, method, 2);
        CombinedCurve far = near;
        for (Point& p : far.points)
            p = p + Vector{0x1p+29, -0x1p+29};
        const PathMeasures here = measured(near);
        const PathMeasures there = measured(far);
        EXPECT_NEAR(there.length / here.length, 1, 1e-15);
        EXPECT_NEAR(*there.bendingEnergy / *here.bendingEnergy, 1, 1e-13);
        EXPECT_NEAR(there.slopeVariation / here.slopeVariation, 1, 1e-13);
        EXPECT_NEAR(there.largestKink, here.largestKink, 1e-15);
    }
}

TEST(Measure, keepsTheDigitsOfBarelyBentCurves) {
    // y = x + h x (1 - x) / 2 from 0 to 1 has the energy h^2 / 2^(5/2), but for a share of h^2.
    for (const double h : {1e-5, 1e-6, 1e-7})
        for (const Method method : {Method::interpolation, Method::pairs}) {
            const double middle = 0.5 + h / 8;
            const PathMeasures measures = measured(pathThrough({{0, 0}, {0.5, middle}, {1, 1}}, method, 2));
            const double bend = 8 * (middle - 0.5); // h as the rounded point has it
            ASSERT_TRUE(measures.bendingEnergy);
            EXPECT_NEAR(*measures.bendingEnergy / (bend * bend * std::pow(2, -2.5)), 1, 1e-9) << h;
        }
}

TEST(Measure, isInfiniteBeyondTheRangeOfDoubles) {
    const PathMeasures measures = measured(pathThrough({{0, 0}, {1e-300, 1e9}, {2e-300, 0}, {1, 1}}));
    EXPECT_TRUE(std::isinf(measures.length));
    EXPECT_TRUE(std::isinf(measures.bounds.ymax));
    EXPECT_FALSE(measures.bendingEnergy);
}

} // namespace
} // namespace kriva
