#include "core/bezier/elevate.h"
#include "core/bezier/evaluate.h"
#include "core/bezier/measures/curvature.h"
#include "core/bezier/measures/curvature_extrema.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace kriva {
namespace {

const Points kParabola{{-1, 1}, {0, -1}, {1, 1}};
const Points kWave{{0, 0}, {1, 3}, {2, -3}, {3, 0}};
const Points kCusp{{0, 0}, {1, 1}, {0, 1}, {1, 0}};

TEST(CurvatureExtrema, ofAParabolaIsItsVertex) {
    ASSERT_EQ(curvatureExtrema(kParabola).size(), 1U);
    EXPECT_NEAR(curvatureExtrema(kParabola)[0], 0.5, 1e-15);
    EXPECT_TRUE(inflections(kParabola).empty());
}

TEST(CurvatureExtrema, ofAWaveLieOnBothSidesOfItsInflection) {
    const std::vector<double> extrema = curvatureExtrema(kWave);
    ASSERT_EQ(extrema.size(), 2U);
    EXPECT_NEAR(extrema[0] + extrema[1], 1, 1e-14);
    ASSERT_EQ(inflections(kWave).size(), 1U);
    EXPECT_NEAR(inflections(kWave)[0], 0.5, 1e-15);
}

TEST(CurvatureExtrema, countACuspOnce) {
    ASSERT_EQ(curvatureExtrema(kCusp).size(), 1U);
    EXPECT_NEAR(curvatureExtrema(kCusp)[0], 0.5, 1e-9);
    EXPECT_TRUE(inflections(kCusp).empty());
}

TEST(CurvatureExtrema, ofStraightAndPointLikeCurvesAreNone) {
    for (const Points& curve : {Points{{1, 1}}, Points(4, Point{1, 1}), Points{{0, 0}, {3, 1}},
                                Points{{0, 0}, {2, 0}, {-1, 1e-10}, {1, 0}}}) {
        EXPECT_TRUE(curvatureExtrema(curve).empty());
        EXPECT_TRUE(inflections(curve).empty());
    }
}

TEST(CurvatureExtrema, leaveOutTheEndsOfHalfAParabola) {
    EXPECT_TRUE(curvatureExtrema(Points{{0, 0}, {0.5, 0}, {1, 1}}).empty());
    EXPECT_TRUE(curvatureExtrema(Points{{1, 1}, {0.5, 0}, {0, 0}}).empty());
}

TEST(CurvatureExtrema, arePresentInTheSmallAndFarAway) {
    for (const double size : {1e-100, 1e-6, 1e9}) {
        Points curve = kWave;
        for (Point& p : curve)
            p = {p.x * size, p.y * size};
        EXPECT_EQ(curvatureExtrema(curve).size(), 2U);
    }
    Points far = kWave;
    for (Point& p : far)
        p = p + Vector{1e9, -1e9};
    EXPECT_EQ(curvatureExtrema(far), curvatureExtrema(kWave));
}

TEST(CurvatureExtrema, ofANearCuspAreResolved) {
    // A cusp that opens into a tiny loop turns once; one that is blunted gains two inflections, and a turn beyond each.
    Points loop = kCusp;
    loop[1].x += 1e-9;
    EXPECT_EQ(curvatureExtrema(loop).size(), 1U);
    EXPECT_TRUE(inflections(loop).empty());
    Points blunt = kCusp;
    blunt[1].x -= 1e-9;
    EXPECT_EQ(curvatureExtrema(blunt).size(), 3U);
    EXPECT_EQ(inflections(blunt).size(), 2U);
}

TEST(CurvatureSlope, hasTheSignOfTheChange) {
    EXPECT_GT(curvatureSlope(kParabola, 0.2).value(), 0);
    EXPECT_LT(curvatureSlope(kParabola, 0.8).value(), 0);
    EXPECT_EQ(curvatureSlope(kParabola, 0.5).value(), 0);
}

TEST(CurvatureSlope, isUnknownWithoutSpeedAndZeroOnLines) {
    EXPECT_FALSE(curvatureSlope(Points{{1, 1}}, 0.5));
    EXPECT_FALSE(curvatureSlope(kCusp, 0.5));
    EXPECT_EQ(curvatureSlope(Points{{0, 0}, {1, 1}}, 0.5), 0.0);
}

RC_GTEST_PROP(CurvatureSlope, isTheDifferenceQuotientOfTheCurvature, ()) {
    const Points curve = *test::anyCurve(2, 6);
    const double t = *rc::gen::element(0.1, 0.4, 0.8);
    const auto slope = curvatureSlope(curve, t);
    const double step = 1e-5;
    const auto before = curvature(curve, t - step);
    const auto after = curvature(curve, t + step);
    const auto here = curvature(curve, t);
    RC_PRE(slope && before && after && !isStraight(curve));
    // Only where the curvature is nearly linear over the step.
    RC_PRE(std::abs(*before + *after - 2 * *here) <= 1e-4 * std::abs(*after - *before));
    const double quotient = (*after - *before) / (2 * step) / length(derivative(curve, t));
    RC_ASSERT(std::abs(quotient - *slope) <= 1e-3 * std::abs(*slope));
}

RC_GTEST_PROP(CurvatureExtrema, splitTheCurveWhereTheSlopeChangesItsSign, ()) {
    const Points curve = *test::anyCurve(2, 6);
    RC_PRE(!isStraight(curve));
    std::vector<double> borders = curvatureExtrema(curve);
    borders.insert(borders.begin(), 0.0);
    borders.push_back(1.0);
    double before = 0;
    for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
        const double width = borders[i + 1] - borders[i];
        RC_PRE(width > 1e-6);
        const auto first = curvatureSlope(curve, borders[i] + 0.1 * width);
        for (const double u : {0.3, 0.5, 0.7, 0.9}) {
            const auto slope = curvatureSlope(curve, borders[i] + u * width);
            RC_PRE(first.has_value() && slope.has_value());
            RC_ASSERT(*first * *slope >= 0);
        }
        RC_ASSERT(before * *first <= 0);
        before = *first;
    }
}

RC_GTEST_PROP(CurvatureExtrema, areAsManyBackwards, ()) {
    const Points curve = *test::anyCurve(2, 6);
    const Points reversed(curve.rbegin(), curve.rend());
    RC_ASSERT(curvatureExtrema(curve).size() == curvatureExtrema(reversed).size());
    RC_ASSERT(inflections(curve).size() == inflections(reversed).size());
}

RC_GTEST_PROP(CurvatureExtrema, surviveElevation, ()) {
    const Points curve = *test::anyCurve(2, 3);
    RC_PRE(!isStraight(curve));
    const std::vector<double> before = curvatureExtrema(curve);
    const std::vector<double> after = curvatureExtrema(elevated(curve, 2));
    // Elevation rounds, which may move turns that nearly touch or nearly leave.
    const auto apart = [](const std::vector<double>& at) {
        double last = 0;
        bool result = true;
        for (const double t : at) {
            result = result && t - last > 1e-4;
            last = t;
        }
        return result && 1 - last > 1e-4;
    };
    RC_PRE(apart(before) && apart(after));
    RC_ASSERT(before.size() == after.size());
    for (std::size_t i = 0; i < before.size(); ++i)
        RC_ASSERT(std::abs(before[i] - after[i]) <= 1e-6);
}

} // namespace
} // namespace kriva
