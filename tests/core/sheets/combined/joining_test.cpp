#include "core/sheets/combined/joining.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <optional>

namespace kriva {
namespace {

CurveEnd end(Point at, double slope, int direction) {
    return {at.x, at.y, tangentOf(slope, direction)};
}

/// Of the quadratic that joins two ends, if it is one.
std::optional<Point> quadraticMiddle(const CurveEnd& from, const CurveEnd& to) {
    const TangentPiece join = joinOf(from, to);
    return join.points.size() == 3 ? std::optional(join.points[1]) : std::nullopt;
}

RC_GTEST_PROP(QuadraticMiddle, isTheClassicPointWhereTheTangentsMeet, ()) {
    const auto number = [] { return *rc::gen::inRange(-1000, 1000) / 64.0; };
    const Point from{number(), number()};
    const Point to{number(), number()};
    const double k1 = number();
    const double k2 = number();
    RC_PRE(!(from == to));
    const std::optional<Point> middle = quadraticMiddle(end(from, k1, 1), end(to, k2, -1));
    RC_PRE(middle.has_value());
    // Formulas (12) and (13) of Rossinsky and Kravchenko.
    const double x = (to.y - from.y + k1 * from.x - k2 * to.x) / (k1 - k2);
    const double y = from.y + k1 * (x - from.x);
    RC_ASSERT(distance(*middle, {x, y}) < 1e-9);
    // It lies ahead of the start and behind the end.
    RC_ASSERT(middle->x > from.x);
    RC_ASSERT(middle->x > to.x);
}

TEST(QuadraticMiddle, isMissingWhereTangentsAreParallel) {
    EXPECT_FALSE(quadraticMiddle(end({0, 0}, 1, 1), end({2, 0}, 1, 1)));
    EXPECT_FALSE(quadraticMiddle(end({0, 0}, 1, 1), end({2, 0}, 1 + 1e-9, 1)));
    EXPECT_TRUE(quadraticMiddle(end({0, 0}, 1, 1), end({2, 2 + 1e-8}, 1 + 1e-8, 1)));
}

TEST(QuadraticMiddle, isMissingBehindAnEnd) {
    EXPECT_TRUE(quadraticMiddle(end({0, 0}, 1, 1), end({2, 0}, -1, 1)));
    EXPECT_FALSE(quadraticMiddle(end({0, 0}, -1, 1), end({2, 0}, 1, -1)));
    EXPECT_FALSE(quadraticMiddle(end({0, 0}, 1, -1), end({2, 0}, -1, -1)));
}

TEST(QuadraticMiddle, isMissingPastAHundredDistances) {
    // Tangents of slope +-k over a distance of 1 meet at a height of k/2, sqrt(1 + k^2) / 2 from either end.
    EXPECT_TRUE(quadraticMiddle(end({0, 0}, 199.9, 1), end({1, 0}, -199.9, 1)));
    EXPECT_FALSE(quadraticMiddle(end({0, 0}, 200.1, 1), end({1, 0}, -200.1, 1)));
}

TEST(TangentOf, isOfLength1AlsoWhereItIsSteep) {
    for (const double slope : {0.0, 0.5, -3.0, 1e200, -1e300})
        for (const int direction : {1, -1}) {
            const Vector t = tangentOf(slope, direction).vector();
            EXPECT_DOUBLE_EQ(length(t), 1);
            EXPECT_GE(t.x * direction, 0);
            EXPECT_EQ(t.y * direction > 0, slope > 0);
        }
    const Vector up = tangentOf(std::numeric_limits<double>::infinity(), 1).vector();
    EXPECT_EQ(up, (Vector{0, 1}));
}

TEST(JoinOf, isCubicWhereTangentsAreParallel) {
    const TangentPiece join = joinOf(end({0, 0}, 0, 1), end({3, 3}, 0, 1));
    const double reach = std::sqrt(2.0);
    ASSERT_EQ(join.points.size(), 4u);
    EXPECT_DOUBLE_EQ(join.points[1].x, reach);
    EXPECT_EQ(join.points[1].y, 0);
    EXPECT_DOUBLE_EQ(join.points[2].x, 3 - reach);
    EXPECT_EQ(join.points[2].y, 3);
}

TEST(JoinOf, runsStraightToASinglePoint) {
    const TangentPiece join = joinOf({0, 0, {}}, {3, 4, {}});
    ASSERT_EQ(join.points.size(), 4u);
    EXPECT_NEAR(distance(join.points[1], {1, 4.0 / 3}), 0, 1e-15);
    EXPECT_NEAR(distance(join.points[2], {2, 8.0 / 3}), 0, 1e-15);
    EXPECT_EQ(join.startTangent, (Vector{0.6, 0.8}));
}

TEST(PairOf, isTwoQuadraticsWhereOneCannotBe) {
    // An S between parallel tangents: the middle points lie d/4 = 5/4 along them.
    const std::vector<TangentPiece> pair = pairOf(end({0, 0}, 0, 1), end({4, 3}, 0, 1));
    ASSERT_EQ(pair.size(), 2u);
    EXPECT_EQ(pair[0].points, (Points{{0, 0}, {1.25, 0}, {2, 1.5}}));
    EXPECT_EQ(pair[1].points, (Points{{2, 1.5}, {2.75, 3}, {4, 3}}));
    EXPECT_EQ(pair[0].endTangent, pair[1].startTangent);
    EXPECT_NEAR(cross(pair[0].endTangent, {0.75, 1.5}), 0, 1e-15);
}

TEST(PairOf, survivesNeighboursARoundingApart) {
    const double next = std::nextafter(1e6, 2e6);
    const std::vector<TangentPiece> pair = pairOf(end({1e6, 5}, 0, 1), end({next, 5}, 0, 1));
    ASSERT_EQ(pair.size(), 2u);
    EXPECT_EQ(pair[0].endTangent, (Vector{1, 0}));
}

} // namespace
} // namespace kriva
