#include "core/bezier/elevate.h"
#include "core/bezier/evaluate.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

TEST(Elevate, raisesACubicByTheTextbookFormula) {
    const Points curve{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    const Points raised{{0, 0}, {0.75, 1.5}, {2, 2}, {3.25, 1.5}, {4, 0}};
    EXPECT_EQ(elevated(curve, 1), raised);
}

TEST(Elevate, zeroTimesChangesNoBit) {
    const Points curve{{0.1, -0.0}, {1e9, 1e-9}, {0.3, 0.7}};
    EXPECT_EQ(elevated(curve, 0), curve);
    EXPECT_TRUE(std::signbit(elevated(curve, 0)[0].y));
}

TEST(Elevate, aSinglePointIsRepeated) {
    EXPECT_EQ(elevated(Points{{2, 3}}, 3), Points(4, Point{2, 3}));
    EXPECT_EQ(elevationGap(Points{{2, 3}}, 3), 0);
}

TEST(Elevate, staysFiniteAndMeetsTheEndsAtTheLimits) {
    Points curve(201);
    for (std::size_t i = 0; i < curve.size(); ++i)
        curve[i] = {i % 2 == 0 ? 1e9 : -1e9, static_cast<double>(i)};
    const Points raised = elevated(curve, 10000);
    ASSERT_EQ(raised.size(), 10201U);
    EXPECT_EQ(raised.front(), curve.front());
    EXPECT_EQ(raised.back(), curve.back());
    for (std::size_t i = 0; i < raised.size(); ++i) {
        EXPECT_LE(std::abs(raised[i].x), 1e9);
        // Elevation keeps the linear function i.
        EXPECT_NEAR(raised[i].y, 200.0 * static_cast<double>(i) / 10200, 1e-11);
    }
}

RC_GTEST_PROP(Elevate, keepsRepeatedEndsBitForBit, ()) {
    Points curve = *test::anyCurve(3, 8);
    curve[1] = curve.front();
    curve[curve.size() - 2] = curve.back();
    const int times = *rc::gen::inRange(1, 20);
    const Points raised = elevated(curve, times);
    RC_ASSERT(raised[1] == curve.front());
    RC_ASSERT(distance(raised[raised.size() - 2], curve.back()) <= 1e-12);
    const Vector start = curve.front() - Point{};
    for (Point& p : curve)
        p = p - start;
    const Points local = elevated(curve, times);
    RC_ASSERT(local[local.size() - 2] == local.back());
}

RC_GTEST_PROP(Elevate, onceMoreEqualsTwiceOnce, ()) {
    const Points curve = *test::anyCurve(1, 12);
    const Points twice = elevated(elevated(curve, 1), 1);
    const Points atOnce = elevated(curve, 2);
    for (std::size_t i = 0; i < atOnce.size(); ++i)
        RC_ASSERT(distance(twice[i], atOnce[i]) <= 1e-12 * 1000);
}

RC_GTEST_PROP(Elevate, keepsTheCurve, ()) {
    const Points curve = *test::anyCurve(0, 12);
    const double t = *test::anyParameter();
    const int times = *rc::gen::inRange(0, 60);
    RC_ASSERT(distance(evaluate(curve, t), evaluate(elevated(curve, times), t)) <= 1e-12 * 1000);
}

RC_GTEST_PROP(Elevate, losesNothingFarFromTheOrigin, ()) {
    const Points curve = *test::anyCurve(1, 12);
    Points far = curve;
    for (Point& p : far)
        p = p + Vector{1e9, -1e9};
    const Points raised = elevated(curve, 20);
    const Points farRaised = elevated(far, 20);
    for (std::size_t i = 0; i < raised.size(); ++i)
        RC_ASSERT(distance(raised[i] + Vector{1e9, -1e9}, farRaised[i]) <= 2e-7);
}

TEST(ElevationGap, isTheLargestDistanceToTheCurve) {
    const Points curve{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    const Points polygon = elevated(curve, 5);
    double largest = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        largest = std::max(largest, distance(polygon[i], evaluate(curve, static_cast<double>(i) / 8)));
    EXPECT_NEAR(elevationGap(curve, 5), largest, 1e-15);
}

TEST(ElevationGap, fallsLikeOneOverTheDegree) {
    const Points curve{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    EXPECT_NEAR(elevationGap(curve, 4000) * 4003, elevationGap(curve, 8000) * 8003, 1e-3);
}

TEST(ElevationGap, isZeroOnLinesRunThroughEvenly) {
    EXPECT_EQ(elevationGap(Points{{1, 1}, {4, 7}}, 7), 0);
    EXPECT_EQ(elevationGap(Points{{0, 0}, {1, 2}, {2, 4}, {3, 6}}, 100), 0);
}

TEST(ElevationGap, isTheSameFarFromTheOrigin) {
    const Points curve{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    Points far = curve;
    for (Point& p : far)
        p = p + Vector{1e9, 1e9};
    EXPECT_NEAR(elevationGap(far, 10000), elevationGap(curve, 10000), 1e-15);
}

} // namespace
} // namespace kriva
