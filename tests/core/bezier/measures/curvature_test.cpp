#include "core/bezier/measures/curvature.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

TEST(Curvature, ofAParabolaAtItsVertex) {
    // (t, t^2) has the curvature 2 / (1 + 4 t^2)^(3/2), and turns left.
    const Points parabola{{0, 0}, {0.5, 0}, {1, 1}};
    EXPECT_DOUBLE_EQ(curvature(parabola, 0).value(), 2);
    EXPECT_DOUBLE_EQ(curvature(parabola, 1).value(), 2 / std::pow(5.0, 1.5));
}

TEST(Curvature, changesItsSignWithTheDirection) {
    const Points curve{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    const Points reversed(curve.rbegin(), curve.rend());
    EXPECT_LT(curvature(curve, 0.5).value(), 0);
    EXPECT_DOUBLE_EQ(curvature(curve, 0.5).value(), -curvature(reversed, 0.5).value());
}

TEST(Curvature, isUnknownWhereTheSpeedIsZero) {
    EXPECT_FALSE(curvature(Points{{1, 1}}, 0.5));
    EXPECT_FALSE(curvature(Points(4, Point{1, 1}), 0.5));
    EXPECT_FALSE(curvature(Points{{0, 0}, {0, 0}, {1, 0}, {1, 1}}, 0));
    EXPECT_EQ(curvature(Points{{0, 0}, {1, 1}}, 0.5), 0.0);
}

TEST(Curvature, survivesTinyAndHugeCurves) {
    for (const double size : {1e-100, 1.0, 1e9}) {
        const Points parabola{{0, 0}, {0.5 * size, 0}, {size, size}};
        EXPECT_NEAR(curvature(parabola, 0).value() * size, 2, 1e-15);
    }
}

TEST(Tangents, skipRepeatedPoints) {
    const Points curve{{0, 0}, {0, 0}, {0, 3}, {4, 3}, {4, 3}};
    EXPECT_EQ(startTangent(curve), (Vector{0, 1}));
    EXPECT_EQ(endTangent(curve), (Vector{1, 0}));
    EXPECT_FALSE(startTangent(Points(3, Point{1, 1})));
    EXPECT_FALSE(endTangent(Points{{1, 1}}));
}

TEST(IsStraight, allowsABillionthOfThePolygonsLength) {
    EXPECT_TRUE(isStraight(Points{{0, 0}, {1, 0.9e-9}, {2, 0}}));
    EXPECT_FALSE(isStraight(Points{{0, 0}, {1, 5e-9}, {2, 0}}));
}

TEST(IsStraight, holdsForPointsLinesAndThoseThatTurnBack) {
    EXPECT_TRUE(isStraight(Points{{1, 1}}));
    EXPECT_TRUE(isStraight(Points(4, Point{1, 1})));
    EXPECT_TRUE(isStraight(Points{{0, 0}, {5, 3}}));
    EXPECT_TRUE(isStraight(Points{{0, 0}, {2, 2}, {-1, -1}, {0, 0}}));
    EXPECT_FALSE(isStraight(Points{{0, 0}, {1, 2}, {3, 2}, {4, 0}}));
}

TEST(PolygonLength, addsTheSides) {
    EXPECT_EQ(polygonLength(Points{{0, 0}, {3, 4}, {3, 5}}), 6);
    EXPECT_EQ(polygonLength(Points{{1, 1}}), 0);
    EXPECT_EQ(polygonLength(Points{}), 0);
}

RC_GTEST_PROP(Curvature, shrinksAsTheCurveGrows, ()) {
    const Points curve = *test::anyCurve(2, 8);
    Points doubled = curve;
    for (Point& p : doubled)
        p = {2 * p.x, 2 * p.y};
    const double t = *test::anyParameter();
    const auto before = curvature(curve, t);
    const auto after = curvature(doubled, t);
    RC_ASSERT(before.has_value() == after.has_value());
    // Doubling is exact, and so is everything that follows from it.
    if (before)
        RC_ASSERT(*before == 2 * *after);
}

} // namespace
} // namespace kriva
