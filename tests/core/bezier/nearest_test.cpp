#include "core/bezier/elevate.h"
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

TEST(Nearest, findsTheTurnOfALineThatRunsBack) {
    const Points line{{4. / 64, 7. / 64}, {6. / 64, 5. / 64}, {3. / 64, 8. / 64}};
    EXPECT_LE(nearest(line, evaluate(line, 0.4)).distance, 1e-16);
    EXPECT_LE(nearest(Points{{0, 0}, {4, 0}, {-4, 0}, {0, 0}}, {5, 0}).distance, 5 - 4 / std::sqrt(12.0) + 1e-15);
}

TEST(Nearest, isNotLedAstrayByAPlaceWhereTheDistanceStandsStill) {
    const Points curve{{1. / 64, -1. / 64}, {-7. / 64, 8. / 64}, {1. / 64, 0}, {-7. / 64, 7. / 64}};
    const NearestPoint found = nearest(curve, evaluate(curve, 0.036)); // at 0.5 the slope is zero and keeps its sign
    EXPECT_NEAR(found.t, 0.036, 1e-14);
    EXPECT_LE(found.distance, 1e-16);
}

RC_GTEST_PROP(Nearest, toManyPointsIsToEachAlone, ()) {
    const Points curve = *test::anyCurve(0, 6);
    const Points points = *rc::gen::container<Points>(test::anyPoint());
    std::vector<NearestPoint> places(points.size());
    nearest(curve, points, places);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const NearestPoint alone = nearest(curve, points[i]);
        RC_ASSERT(places[i].t == alone.t);
        RC_ASSERT(places[i].at == alone.at);
        RC_ASSERT(places[i].distance == alone.distance);
    }
}

RC_GTEST_PROP(Nearest, isAsNearToTheCurveToldByOneDegreeMore, ()) {
    const Points curve = *test::anyCurve(1, 4); // up to degree 3 the search is another one than above
    const Point point = *test::anyPoint();
    RC_ASSERT(std::abs(nearest(curve, point).distance - nearest(elevated(curve, 4), point).distance) <= 1e-12 * 3000);
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
