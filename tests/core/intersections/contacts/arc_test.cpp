#include "core/bezier/evaluate.h"
#include "core/bezier/subdivide.h"
#include "tests/core/intersections/arcs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

using test::kArch;
using test::plainArc;

/// Of values of arcs about as large as 1.
constexpr double kAllowed = 1e-14;

std::vector<double> parameters() {
    std::vector<double> all;
    for (int i = 0; i <= 32; ++i)
        all.push_back(i / 32.0);
    return all;
}

Box boxOf(const Arc& arc) {
    return kriva::boxOf(arc.polygon());
}

TEST(Arc, countsFromTheFrame) {
    const Arc arc = arcOf(Points{{10, 20}, {14, 20}, {14, 28}}, {{10, 20}, 4});
    EXPECT_EQ(arc.degree, 2U);
    EXPECT_EQ(arc.front(), (Point{0, 0}));
    EXPECT_EQ(arc.points[1], (Point{1, 0}));
    EXPECT_EQ(arc.back(), (Point{1, 2}));
    EXPECT_EQ(arc.chord(), (Vector{1, 2}));
    EXPECT_EQ(arc.box, (Box{0, 0, 1, 2}));
    EXPECT_EQ(arc.size(), 2);
    EXPECT_EQ(arc.from, 0);
    EXPECT_EQ(arc.to, 1);
    EXPECT_EQ(arc.polygon().size(), 3U);
}

TEST(Arc, ofOnePointHasNoSize) {
    const Arc arc = plainArc(Points(4, Point{3, 4}));
    EXPECT_EQ(arc.size(), 0);
    EXPECT_EQ(arc.chord(), Vector());
    EXPECT_LE(distance(evaluate(arc, 0.3).at, {3, 4}), kAllowed);
    EXPECT_EQ(evaluate(arc, 0.3).velocity, Vector());
    EXPECT_FALSE(tangentCone(arc));
}

RC_GTEST_PROP(Arc, isTheSegmentInsideAndOutside, ()) {
    const Points segment = *test::anyCurve(1, 5);
    const Arc arc = arcOf(segment, test::kFrame);
    for (const double t : {-0.5, 0.0, 0.3, 1.0, 1.25}) {
        const auto [at, velocity] = evaluate(arc, t);
        RC_ASSERT(length(1024 * (at - Point{}) - (evaluate(segment, t) - Point{})) <= 1e-9);
        RC_ASSERT(length(1024 * velocity - derivative(segment, t)) <= 1e-8);
    }
}

RC_GTEST_PROP(Arc, isTheSameInHalves, ()) {
    const Arc arc = *test::anyArc();
    const auto [left, right] = halved(arc);
    RC_ASSERT(left.front() == arc.front());
    RC_ASSERT(right.back() == arc.back());
    RC_ASSERT(left.back() == right.front());
    RC_ASSERT(left.from == 0 && left.to == 0.5 && right.from == 0.5 && right.to == 1);
    RC_ASSERT(left.box == boxOf(left));
    RC_ASSERT(right.box == boxOf(right));
    for (const double t : parameters()) {
        RC_ASSERT(distance(evaluate(left, t).at, evaluate(arc, t / 2).at) <= kAllowed);
        RC_ASSERT(distance(evaluate(right, t).at, evaluate(arc, 0.5 + t / 2).at) <= kAllowed);
    }
}

TEST(Arc, keepsItsEndsHoweverOftenItIsHalved) {
    Arc first = plainArc(Points{{0.1, 0.7}, {0.3, 0.9}, {0.8, 0.2}, {0.6, 0.3}, {0.1, 0.5}, {0.7, 0.1}});
    Arc last = first;
    for (int i = 0; i < 40; ++i) {
        first = halved(first).left;
        last = halved(last).right;
    }
    EXPECT_EQ(first.front(), (Point{0.1, 0.7}));
    EXPECT_EQ(last.back(), (Point{0.7, 0.1}));
    EXPECT_EQ(first.to, 0x1p-40);
    EXPECT_EQ(last.from, 1 - 0x1p-40);
}

RC_GTEST_PROP(Arc, isTheSameInParts, ()) {
    const Arc arc = *test::anyArc();
    const auto [from, to] = *test::anyStretch();
    const Arc stretch = part(arc, from, to);
    RC_ASSERT(stretch.from == from && stretch.to == to);
    RC_ASSERT(stretch.degree == arc.degree);
    RC_ASSERT(stretch.box == boxOf(stretch));
    for (const double t : parameters())
        RC_ASSERT(distance(evaluate(stretch, t).at, evaluate(arc, stretch.parameter(t)).at) <= 10 * kAllowed);
}

RC_GTEST_PROP(Arc, ofAPartKnowsTheParametersOfTheSegment, ()) {
    const Arc arc = *test::anyArc();
    const auto [from, to] = *test::anyStretch();
    const Arc stretch = part(part(arc, 0.25, 0.75), from, to);
    RC_ASSERT(stretch.from == 0.25 + from / 2);
    RC_ASSERT(stretch.to == 0.25 + to / 2);
    for (const double t : parameters())
        RC_ASSERT(distance(evaluate(stretch, t).at, evaluate(arc, stretch.parameter(t)).at) <= 10 * kAllowed);
}

RC_GTEST_PROP(Arc, runsTheOtherWayReversed, ()) {
    const Arc arc = part(*test::anyArc(), 0.25, 1);
    const Arc back = reversed(arc);
    RC_ASSERT(back.from == 1 && back.to == 0.25);
    RC_ASSERT(back.box == arc.box);
    for (const double t : parameters()) {
        RC_ASSERT(distance(evaluate(back, t).at, evaluate(arc, 1 - t).at) <= kAllowed);
        RC_ASSERT(length(evaluate(back, t).velocity + evaluate(arc, 1 - t).velocity) <= 1e-12);
    }
    const Arc again = reversed(back);
    RC_ASSERT(again.points == arc.points);
    RC_ASSERT(again.from == arc.from && again.to == arc.to);
}

RC_GTEST_PROP(TangentCone, holdsAllTangents, ()) {
    const Arc arc = *test::anyArc();
    const auto cone = tangentCone(arc);
    if (!cone)
        return;
    RC_ASSERT(dot(cone->right, arc.chord()) > 0);
    RC_ASSERT(dot(cone->left, arc.chord()) > 0);
    RC_ASSERT(cross(cone->right, cone->left) >= 0);
    for (const double t : parameters()) {
        const Vector velocity = evaluate(arc, t).velocity;
        RC_ASSERT(cross(cone->right, velocity) >= -1e-12);
        RC_ASSERT(cross(velocity, cone->left) >= -1e-12);
    }
}

TEST(TangentCone, isTheFirstAndTheLastSideOfAConvexPolygon) {
    const auto cone = tangentCone(plainArc(Points{{0, 0}, {1, 2}, {3, 3}, {5, 2}}));
    ASSERT_TRUE(cone);
    EXPECT_EQ(cone->left, (Vector{1, 2}));
    EXPECT_EQ(cone->right, (Vector{2, -1}));
}

TEST(TangentCone, isOneDirectionOfALineAndLeavesOutRepeatedPoints) {
    const auto cone = tangentCone(plainArc(Points{{0, 0}, {0, 0}, {1, 1}, {1, 1}, {3, 3}}));
    ASSERT_TRUE(cone);
    EXPECT_EQ(cross(cone->left, cone->right), 0);
    EXPECT_GT(dot(cone->left, Vector{1, 1}), 0);
}

TEST(TangentCone, isNoneWhereThePolygonTurnsBack) {
    EXPECT_FALSE(tangentCone(plainArc(Points{{0, 0}, {2, 0}, {1, 0}})));
    EXPECT_FALSE(tangentCone(plainArc(Points{{0, 0}, {0, 1}, {4, 1}, {4, 0}}))) << "a right angle with the chord";
    EXPECT_FALSE(tangentCone(plainArc(Points{{0, 0}, {2, 1}, {0, 0}}))) << "no chord";
}

TEST(Transversal, areConesWithoutAParallel) {
    const TangentCone narrow{{4, -1}, {4, 1}};
    EXPECT_TRUE(areTransversal(narrow, {{1, 4}, {-1, 4}}));
    EXPECT_TRUE(areTransversal(narrow, {{-1, -4}, {1, -4}}));
    EXPECT_FALSE(areTransversal(narrow, narrow));
    EXPECT_FALSE(areTransversal(narrow, {{4, 0}, {1, 4}})) << "they overlap";
    EXPECT_FALSE(areTransversal(narrow, {{1, 4}, {-4, 0}})) << "parallel, and the other way round";
    EXPECT_FALSE(areTransversal(narrow, {{8, 2}, {1, 4}})) << "they share a border";
    EXPECT_FALSE(areTransversal(narrow, {{4, 1 + 1e-10}, {1, 4}})) << "but for rounding";
    EXPECT_TRUE(areTransversal(narrow, {{4, 1 + 1e-7}, {1, 4}}));
}

RC_GTEST_PROP(Transversal, areArcsWhoseTangentsAreNeverParallel, ()) {
    const Arc a = *test::anyArc(), b = *test::anyArc();
    const auto coneA = tangentCone(a), coneB = tangentCone(b);
    if (!coneA || !coneB)
        return;
    RC_ASSERT(areTransversal(*coneA, *coneB) == areTransversal(*coneB, *coneA));
    if (!areTransversal(*coneA, *coneB))
        return;
    const double first = cross(evaluate(a, 0).velocity, evaluate(b, 0).velocity);
    for (const double t : parameters())
        for (const double s : parameters())
            RC_ASSERT(first * cross(evaluate(a, t).velocity, evaluate(b, s).velocity) >= -1e-12);
}

TEST(Apart, areArcsWithAStripBetweenThem) {
    const Arc arch = plainArc(kArch), above = plainArc(Points{{-1, 5}, {2, 4.25}, {5, 6}});
    EXPECT_TRUE(areApart(arch, above, 0)) << "of both polygons";
    const Arc line = plainArc(Points{{0, 0}, {4, 3}}), beside = plainArc(Points{{0, 1}, {4, 4}}); // 4/5 away
    EXPECT_TRUE(areApart(line, beside, 0.79));
    EXPECT_FALSE(areApart(line, beside, 0.81));
    const Arc ahead = plainArc(Points{{8, 6}, {5, 6}, {8, 7}}); // 7 1/2 - 5 along the line
    EXPECT_TRUE(areApart(line, ahead, 2.5));
    EXPECT_TRUE(areApart(ahead, line, 2.5));
}

RC_GTEST_PROP(Apart, areOnlyArcsFartherThanTheGap, ()) {
    const Arc a = *test::anyArc(), b = *test::anyArc();
    const double gap = *rc::gen::elementOf(std::vector{0.0, 1e-12, 0.1, 0.5});
    RC_ASSERT(areApart(a, b, gap) == areApart(b, a, gap));
    if (areApart(a, b, gap))
        for (const double t : parameters())
            for (const double s : parameters())
                RC_ASSERT(gapAt(a, b, {t, s}) > gap * (1 - 1e-12));
}

TEST(GapAt, isTheDistanceAtTheArcsOwnParameters) {
    const Arc arc = part(plainArc(Points{{0, 0}, {4, 0}}), 0.5, 1), other = plainArc(Points{{0, 3}, {8, 3}});
    EXPECT_EQ(gapAt(arc, other, {0, 0.25}), 3); // (2, 0) and (2, 3)
    EXPECT_EQ(gapAt(arc, other, {1, 1}), 5);
}

} // namespace
} // namespace kriva
