#include "core/bezier/evaluate.h"
#include "core/bezier/nearest.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

TEST(Nearest, toAnArchFromAboveAndBelow) {
    const Points arch{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    const NearestPoint top = nearest(arch, {2, 5});
    EXPECT_NEAR(top.t, 0.5, 1e-15);
    EXPECT_EQ(top.distance, 3.5);
    // From below both ends are equally near: the first one counts.
    EXPECT_EQ(nearest(arch, {2, -5}).t, 0);
    EXPECT_EQ(nearest(arch, {3, -5}).t, 1);
}

TEST(Nearest, ofACurveOfOnePlace) {
    EXPECT_EQ(nearest(Points{{1, 1}}, {4, 5}).distance, 5);
    EXPECT_EQ(nearest(Points(5, Point{1, 1}), {4, 5}).distance, 5);
    EXPECT_EQ(nearest(Points(5, Point{1, 1}), {1, 1}).t, 0);
}

TEST(Nearest, findsTheCusp) {
    const NearestPoint found = nearest(Points{{0, 0}, {1, 1}, {0, 1}, {1, 0}}, {0.5, 2});
    EXPECT_NEAR(found.distance, 1.25, 1e-12);
}

TEST(Nearest, toAPlaceBesideACuspIsThere) {
    // Where the curve is slow, the coefficients of the squared distance tell its least value to some 1e-11 only.
    for (const Points& cusp : {Points{{0, 0}, {1, 1}, {0, 1}, {1, 0}},                  // at (1/2, 3/4)
                               Points{{-1, 1}, {1, -1.0 / 3}, {-1, -1.0 / 3}, {1, 1}}}) // (x^3, x^2)
        for (double away = 1e-7; away < 1e-2; away *= 1.1)
            ASSERT_LE(nearest(cusp, evaluate(cusp, 0.5 + away)).distance, 1e-12) << away;
}

TEST(Nearest, seesFarPointsAndFarCurves) {
    const Points arch{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    EXPECT_NEAR(nearest(arch, {2, 1e9}).at.y, 1.5, 1e-9);
    Points far = arch;
    for (Point& p : far)
        p = p + Vector{1e9, 1e9};
    EXPECT_NEAR(nearest(far, {1e9 + 2, 1e9 + 2}).distance, 0.5, 1e-6);
}

RC_GTEST_PROP(Nearest, isNoFartherThanAnySample, ()) {
    const Points curve = *test::anyCurve(1, 10);
    const Point point = *test::anyPoint();
    const NearestPoint found = nearest(curve, point);
    RC_ASSERT(0 <= found.t && found.t <= 1);
    RC_ASSERT(distance(evaluate(curve, found.t), found.at) == 0);
    RC_ASSERT(found.distance == distance(found.at, point));
    RC_ASSERT(leastDistance(curve, point) <= found.distance * (1 + 1e-12));
    for (int i = 0; i <= 500; ++i)
        RC_ASSERT(found.distance <= distance(evaluate(curve, i / 500.0), point) + 1e-12 * 3000);
}

RC_GTEST_PROP(Nearest, toAPointOfTheCurveIsThere, ()) {
    const Points curve = *test::anyCurve(1, 10);
    const Point point = evaluate(curve, *test::anyParameter());
    RC_ASSERT(nearest(curve, point).distance <= 1e-12 * 3000);
}

} // namespace
} // namespace kriva
