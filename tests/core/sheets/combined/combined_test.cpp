#include "core/sheets/combined/combined.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>

namespace kriva {
namespace {

using ::testing::ElementsAre;
using Basis = CombinedCurve::Basis;
using Method = CombinedCurve::Method;

CombinedCurve curveThrough(Points points, Method method = Method::approximation, int degree = 3) {
    CombinedCurve curve;
    curve.points = std::move(points);
    curve.method = method;
    curve.degree = degree;
    return curve;
}

const Points kParabola{{-2, 4}, {-1, 1}, {0, 0}, {1, 1}, {2, 4}, {3, 9}};

CombinedCurve anyCurve(Method method) {
    const auto number = [] { return *rc::gen::inRange(-20, 20) / 4.0; };
    CombinedCurve curve = curveThrough({}, method, *rc::gen::inRange(1, 6));
    const int count = *rc::gen::inRange(1, 30);
    for (int i = 0; i < count; ++i)
        curve.points.push_back({number(), number()});
    return curve;
}

RC_GTEST_PROP(Combine, drawsOneUnbrokenPath, ()) {
    const CombinedCurve curve =
        anyCurve(*rc::gen::element(Method::approximation, Method::interpolation, Method::pairs));
    const Combined combined = combine(curve);
    for (std::size_t i = 1; i < combined.path.size(); ++i)
        RC_ASSERT(distance(combined.path[i - 1].curve.points.back(), combined.path[i].curve.points.front()) < 1e-10);
}

RC_GTEST_PROP(Combine, passesThroughEveryPointInPairs, ()) {
    CombinedCurve curve = anyCurve(Method::pairs);
    if (curve.points.size() > 1)
        curve.corrections[*rc::gen::inRange(0, static_cast<int>(curve.points.size()) - 1)] = {1, 2};
    const Combined combined = combine(curve);
    for (const PathPiece& piece : combined.path) {
        if (piece.kind != PathPiece::Kind::pair)
            continue;
        const Point first = curve.points[static_cast<std::size_t>(piece.index)];
        const Point second = curve.points[static_cast<std::size_t>(piece.index) + 1];
        RC_ASSERT(piece.curve.points.front() == first || piece.curve.points.back() == second);
    }
    for (const CombinedRun& run : combined.runs) {
        RC_ASSERT(run.start.point() == curve.points[static_cast<std::size_t>(run.points.first)]);
        RC_ASSERT(run.end.point() == curve.points[static_cast<std::size_t>(run.points.last)]);
    }
}

RC_GTEST_PROP(Combine, meetsItsTangentsWithoutAKinkUnderPairs, ()) {
    const CombinedCurve curve = anyCurve(Method::pairs);
    const Combined combined = combine(curve);
    for (std::size_t i = 1; i < combined.path.size(); ++i) {
        const PathPiece& before = combined.path[i - 1];
        const PathPiece& after = combined.path[i];
        const bool arePairs = before.kind == PathPiece::Kind::pair && after.kind == PathPiece::Kind::pair;
        // Two runs that meet may turn; between their pairs one index is missing.
        if (arePairs && after.index <= before.index + 1)
            RC_ASSERT(std::abs(cross(before.curve.endTangent, after.curve.startTangent)) < 1e-15);
    }
}

TEST(Combine, joinsTwoLinesOverTheirCrossing) {
    // Slopes 1 and -1 through (2, 2) and (1, 4): formulas (12) and (13) give x = (4 - 2 + 2 + 1) / 2 and y = 2 + x - 2.
    const Combined combined = combine(curveThrough({{0, 0}, {1, 1}, {2, 2}, {1, 4}, {0, 5}}, Method::approximation, 1));
    ASSERT_EQ(combined.runs.size(), 2u);
    EXPECT_THAT(combined.runs[0].coefficients, ElementsAre(0, 1));
    EXPECT_THAT(combined.runs[1].coefficients, ElementsAre(5, -1));
    EXPECT_EQ(combined.runs[1].points.direction, -1);
    EXPECT_EQ(combined.runs[1].startSlope, -1);
    ASSERT_EQ(combined.joins.size(), 1u);
    EXPECT_TRUE(combined.joins[0].isQuadratic);
    EXPECT_EQ(combined.joins[0].points, (Points{{2, 2}, {2.5, 2.5}, {1, 4}}));
    ASSERT_EQ(combined.path.size(), 3u);
    EXPECT_EQ(combined.path[2].curve.points, (Points{{1, 4}, {0, 5}}));
}

TEST(Combine, tellsTheParabolaInFourBases) {
    CombinedCurve curve = curveThrough(kParabola, Method::approximation, 2);
    const auto run = [&](Basis basis) {
        curve.basis = basis;
        return combine(curve).runs[0];
    };
    EXPECT_THAT(run(Basis::power).coefficients, ElementsAre(0, 0, 1));
    EXPECT_THAT(run(Basis::power).nodes, ElementsAre());
    EXPECT_THAT(run(Basis::newton).coefficients, ElementsAre(4, -3, 1));
    EXPECT_THAT(run(Basis::newton).nodes, ElementsAre(-2, -1, 0));
    EXPECT_THAT(run(Basis::lagrange).coefficients, ElementsAre(4, 0.25, 9));
    EXPECT_THAT(run(Basis::lagrange).nodes, ElementsAre(-2, 0.5, 3));
    EXPECT_THAT(run(Basis::chebyshev).coefficients, ElementsAre(3.375, 2.5, 3.125));
    EXPECT_EQ(run(Basis::power).startSlope, -4);
    EXPECT_EQ(run(Basis::power).endSlope, 6);
}

TEST(Combine, keepsTheDegreeOfAnInterpolation) {
    CombinedCurve curve = curveThrough(kParabola, Method::interpolation);
    curve.basis = Basis::lagrange;
    const Combined combined = combine(curve);
    EXPECT_EQ(combined.runs[0].degree, 5);
    EXPECT_THAT(combined.runs[0].coefficients, ElementsAre(4, 1, 0, 1, 4, 9));
    EXPECT_EQ(combined.runs[0].maxError, 0);
    ASSERT_EQ(combined.path.size(), 1u);
    // x^2 on [-2, 3] at degree 5.
    EXPECT_EQ(combined.path[0].curve.points, (Points{{-2, 4}, {-1, 0}, {0, -1.5}, {1, -0.5}, {2, 3}, {3, 9}}));
}

TEST(Combine, bendsPairsAlongTheSlopesOfTheApproximation) {
    CombinedCurve curve = curveThrough(kParabola, Method::pairs, 2);
    curve.corrections[2] = {0.5, -1};
    const Combined combined = combine(curve);
    ASSERT_EQ(combined.path.size(), 5u);
    EXPECT_LT(distance(combined.path[1].curve.points[1], {-0.5, 0}), 1e-15);
    EXPECT_EQ(combined.path[2].curve.points, (Points{{0, 0}, {0.5, -1}, {1, 1}}));
    EXPECT_LT(distance(combined.path[3].curve.points[1], {1.5, 2}), 1e-15);
    const std::vector<PairMiddle> middles = pairMiddles(combined);
    ASSERT_EQ(middles.size(), 5u);
    EXPECT_EQ(middles[2].at, (Point{0.5, -1}));
}

TEST(Combine, ignoresCorrectionsAcrossRunsAndUnderOtherMethods) {
    CombinedCurve curve = curveThrough({{0, 0}, {1, 1}, {0, 2}, {-1, 5}}, Method::pairs);
    const std::size_t pieces = combine(curve).path.size();
    curve.corrections[1] = {7, 7};
    const Combined corrected = combine(curve);
    EXPECT_EQ(corrected.path.size(), pieces);
    for (const PathPiece& piece : corrected.path)
        EXPECT_THAT(piece.curve.points, ::testing::Not(::testing::Contains(Point{7, 7})));
    curve.corrections = {{0, {7, 7}}};
    curve.method = Method::approximation;
    EXPECT_EQ(combine(curve).path[0].curve.points.size(), 2u);
}

TEST(Combine, hasNoSlopeNorPieceAtASinglePoint) {
    const Combined combined = combine(curveThrough({{3, 4}}));
    ASSERT_EQ(combined.runs.size(), 1u);
    EXPECT_EQ(combined.runs[0].degree, 0);
    EXPECT_THAT(combined.runs[0].coefficients, ElementsAre(4));
    EXPECT_FALSE(combined.runs[0].startSlope);
    EXPECT_EQ(combined.runs[0].start.point(), (Point{3, 4}));
    EXPECT_TRUE(combined.path.empty());
}

TEST(Combine, joinsSinglePointsByCubics) {
    CombinedCurve curve = curveThrough({{0, 0}, {0, 3}, {0, 3}, {0, 6}});
    curve.basis = Basis::newton;
    const Combined combined = combine(curve);
    ASSERT_EQ(combined.runs.size(), 4u);
    EXPECT_THAT(combined.runs[1].nodes, ElementsAre(0));
    // The second and the third point meet: no join.
    ASSERT_EQ(combined.joins.size(), 2u);
    EXPECT_FALSE(combined.joins[0].isQuadratic);
    EXPECT_EQ(combined.joins[0].points, (Points{{0, 0}, {0, 1}, {0, 2}, {0, 3}}));
    EXPECT_EQ(combined.joins[1].afterRun, 2);
}

TEST(Combine, survivesWhatDoublesCannotHold) {
    // 1e9 within 1e-300, and 1 beyond: the polynomial leaves the range of doubles.
    Points points{{0, 0}, {1e-300, 1e9}, {2e-300, 0}, {1, 1}};
    for (const Method method : {Method::approximation, Method::interpolation, Method::pairs})
        EXPECT_FALSE(combine(curveThrough(points, method)).path.empty());
}

} // namespace
} // namespace kriva
