#include "core/bezier/evaluate.h"
#include "core/curve/limits.h"
#include "core/sheets/combined/combined.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>
#include <set>

namespace kriva {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

/// Points along a zigzag with a correction for every pair, whose x names its first point.
CombinedCurve corrected(int count) {
    CombinedCurve curve;
    curve.method = CombinedCurve::Method::pairs;
    for (int i = 0; i < count; ++i)
        curve.points.push_back({static_cast<double>(i % 5), static_cast<double>(i)});
    for (int i = 0; i + 1 < count; ++i)
        curve.corrections[i] = {static_cast<double>(i), 0.5};
    return curve;
}

RC_GTEST_PROP(CombinedEdits, removalKeepsCorrectionsWithTheirPairs, ()) {
    const CombinedCurve curve = corrected(*rc::gen::inRange(1, 20));
    const auto count = static_cast<int>(curve.points.size());
    const std::set<int> chosen = *rc::gen::container<std::set<int>>(rc::gen::inRange(0, count));
    const Edited<CombinedCurve> edited = withPointsRemoved(curve, {chosen.begin(), chosen.end()});
    std::size_t kept = 0;
    for (int i = 0; i + 1 < count; ++i) {
        if (chosen.contains(i) || chosen.contains(i + 1))
            continue;
        ++kept;
        RC_ASSERT(edited.curve.corrections.at(edited.map(i)) == curve.corrections.at(i));
    }
    RC_ASSERT(edited.curve.corrections.size() == kept);
    RC_ASSERT(edited.curve.points.size() == curve.points.size() - chosen.size());
}

RC_GTEST_PROP(CombinedEdits, reversingTwiceChangesNothing, ()) {
    const CombinedCurve curve = corrected(*rc::gen::inRange(0, 20));
    RC_ASSERT(reversed(reversed(curve).curve).curve == curve);
}

RC_GTEST_PROP(CombinedEdits, insertionIsTakenBackByRemoval, ()) {
    CombinedCurve curve = corrected(*rc::gen::inRange(1, 20));
    const int at = *rc::gen::inRange(0, static_cast<int>(curve.points.size()) + 1);
    const CombinedCurve inserted = withPointInserted(curve, at, {0.25, 0.25}).curve;
    curve.corrections.erase(at - 1); // its pair is taken apart
    RC_ASSERT(withPointsRemoved(inserted, {at}).curve == curve);
}

TEST(CombinedEdits, reversingTurnsPairsRound) {
    CombinedCurve curve = corrected(4);
    curve.corrections = {{0, {9, 9}}};
    EXPECT_THAT(reversed(curve).curve.corrections, ElementsAre(Pair(2, Point{9, 9})));
}

TEST(CombinedEdits, aNewLastPointTouchesNoPair) {
    const CombinedCurve curve = corrected(3);
    const Edited<CombinedCurve> edited = withPointAdded(curve, {7, 7});
    EXPECT_EQ(edited.curve.corrections, curve.corrections);
    EXPECT_EQ(edited.curve.points.back(), (Point{7, 7}));
    EXPECT_EQ(edited.map(2), 2);
}

TEST(CombinedEdits, appendedPointsBringTheCorrectionsOfTheirPairs) {
    CombinedCurve other = corrected(3);
    other.corrections = {{0, {9, 9}}, {7, {1, 1}}}; // pairs that it does not have come from nowhere good
    CombinedCurve curve = corrected(3);
    curve.corrections = {{1, {8, 8}}};
    const CombinedCurve both = appended(curve, other);
    EXPECT_EQ(both.points.size(), curve.points.size() + other.points.size());
    EXPECT_THAT(both.corrections,
                ElementsAre(Pair(1, Point{8, 8}), Pair(static_cast<int>(curve.points.size()), Point{9, 9})));
}

TEST(CombinedEdits, theFirstPointsDropCorrectionsOfPairsThatDoNotCome) {
    CombinedCurve curve;
    curve.corrections = {{0, {9, 9}}, {5, {1, 1}}};
    const Points points{{0, 0}, {1, 1}};
    EXPECT_THAT(withPointsAdded(curve, points).corrections, ElementsAre(Pair(0, Point{9, 9})));
    EXPECT_EQ(withPointsAdded(curve, {}), curve);
}

TEST(CombinedEdits, middlePointsOfPairsAreGrips) {
    CombinedCurve curve;
    curve.points = {{-1, 1}, {0, 0}, {1, 1}, {0, 3}};
    curve.degree = 2;
    EXPECT_EQ(grips(curve).size(), 4u);
    curve.method = CombinedCurve::Method::pairs;
    const std::vector<Grip> all = grips(curve);
    // The step from (1, 1) to (0, 3) is between two runs: no pair.
    ASSERT_EQ(all.size(), 6u);
    EXPECT_EQ(all[4].id, (GripId{GripKind::middle, 0}));
    EXPECT_LT(distance(all[4].at, {-0.5, 0}), 1e-15);
    EXPECT_EQ(all[5].id, (GripId{GripKind::middle, 1}));
    EXPECT_LT(distance(all[5].at, {0.5, 0}), 1e-15);
}

TEST(CombinedEdits, aMovedMiddlePointBecomesACorrection) {
    CombinedCurve curve;
    curve.points = {{-1, 1}, {0, 0}, {1, 1}};
    curve.degree = 2;
    curve.method = CombinedCurve::Method::pairs;
    const std::vector<GripId> ids{{GripKind::middle, 0}, {GripKind::middle, 7}, {GripKind::inner, 0}};
    const CombinedCurve moved = withGripsMoved(curve, ids, {0.25, -1});
    EXPECT_EQ(moved.points, curve.points);
    EXPECT_THAT(moved.corrections, ElementsAre(Pair(0, Point{-0.25, -1})));
    EXPECT_EQ(withCorrection(moved, 0, {}), curve);
}

TEST(CombinedEdits, movedPointsLeaveCorrectionsInPlace) {
    const CombinedCurve curve = corrected(3);
    const std::vector<GripId> ids{{GripKind::point, 1}};
    const CombinedCurve moved = withGripsMoved(curve, ids, {0.5, 2});
    EXPECT_EQ(moved.points[1], (Point{1.5, 3}));
    EXPECT_EQ(moved.corrections, curve.corrections);
}

TEST(CombinedEdits, aPairIsMouldedThroughAPlace) {
    CombinedCurve curve = corrected(3);
    const Point place{0.5, 4};
    const Point middle = withPairThrough(curve, 1, 0.25, place).corrections.at(1);
    const Point start = curve.points[1];
    const Point end = curve.points[2];
    EXPECT_NEAR(distance(lerp(lerp(start, middle, 0.25), lerp(middle, end, 0.25), 0.25), place), 0, 1e-14);
}

TEST(CombinedEdits, interpolationLimitsTheRuns) {
    CombinedCurve curve;
    for (int i = 0; i < 201; ++i)
        curve.points.push_back({static_cast<double>(i), 0});
    curve.points.push_back({0, 0}); // another run
    curve.method = CombinedCurve::Method::interpolation;
    EXPECT_FALSE(pointLimitError(curve));
    curve.points.back().x = 500;
    EXPECT_EQ(pointLimitError(curve).value().numbers, (std::vector<double>{201, 202}));
    curve.method = CombinedCurve::Method::pairs;
    EXPECT_FALSE(pointLimitError(curve));
    curve.points.resize(limits::kPointsInCurve + 1);
    EXPECT_EQ(pointLimitError(curve).value().problem, FileProblem::tooManyPointsInCurve);
}

TEST(CombinedEdits, aPointInsertedIntoAnInterpolationKeepsItsShape) {
    CombinedCurve curve;
    curve.points = {{0, 0}, {1, 2}, {3, 1}, {4, 5}, {2, 6}};
    curve.method = CombinedCurve::Method::interpolation;
    const Points before = combine(curve).path.front().curve.points;
    const Edited<CombinedCurve> edited = *withPointInserted(curve, {2, 1.7});
    EXPECT_EQ(edited.map(1), 1);
    EXPECT_EQ(edited.map(2), 3);
    const Points after = combine(edited.curve).path.front().curve.points;
    for (const double t : {0.1, 0.4, 0.9})
        EXPECT_NEAR(distance(evaluate(after, t), evaluate(before, t)), 0, 1e-12);
}

TEST(CombinedEdits, aPointIsInsertedBehindAnotherOnThePath) {
    CombinedCurve curve;
    curve.points = {{0, 0}, {1, 2}, {3, 1}, {2, 6}};
    curve.degree = 1;
    const auto inserted = [&](std::optional<int> point) {
        const Edited<CombinedCurve> edited = *withPointInsertedBehind(curve, point);
        int index = 0;
        while (edited.map(index) == index)
            ++index;
        return std::pair(index, edited.curve.points[static_cast<std::size_t>(index)]);
    };
    EXPECT_EQ(inserted(0).first, 1);
    EXPECT_EQ(inserted(0).second.x, 0.5);
    EXPECT_EQ(inserted(3).first, 3) << "before the last point";
    EXPECT_EQ(inserted({}).first, 3) << "where two neighbours are farthest apart";
    curve.method = CombinedCurve::Method::pairs;
    EXPECT_EQ(inserted(1).first, 2);
    EXPECT_FALSE(withPointInsertedBehind(CombinedCurve{}, {}));
}

TEST(CombinedEdits, aPointCanBeInsertedBetweenPointsInOnePlace) {
    CombinedCurve curve;
    curve.points = {{1, 1}, {1, 1}};
    EXPECT_EQ(withPointInserted(curve, {2, 2})->curve.points, (Points{{1, 1}, {2, 2}, {1, 1}}));
    EXPECT_EQ(withPointInsertedBehind(curve, {})->curve.points, Points(3, Point{1, 1}));
}

} // namespace
} // namespace kriva
