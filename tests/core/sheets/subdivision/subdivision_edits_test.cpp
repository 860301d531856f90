#include "core/curve/limits.h"
#include "core/geometry/box.h"
#include "core/sheets/subdivision/subdivision.h"
#include "tests/core/sheets/subdivision/any_subdivision.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

namespace kriva {
namespace {

using test::anyPoint;
using test::anySubdivision;
using test::hasValidCounts;

SubdivisionCurve example() {
    SubdivisionCurve curve;
    curve.points = {{0, 0}, {1, 2}, {3, 1}};
    curve.multiplicity = {1, 2, 1};
    curve.t = 0.25;
    curve.blossom = {0, 0.5, 1};
    return curve;
}

TEST(SubdivisionEdits, aNewPointStandsOnceAndTheBlossomGainsT) {
    const auto [curve, map] = withPointAdded(example(), {5, 5});
    EXPECT_EQ(curve.points.back(), (Point{5, 5}));
    EXPECT_EQ(curve.multiplicity, (std::vector{1, 2, 1, 1}));
    EXPECT_EQ(curve.blossom, (std::vector<double>{0, 0.5, 1, 0.25}));
    EXPECT_EQ(map(2), 2);
}

TEST(SubdivisionEdits, roomIsCountedWithMultiplicitiesAlsoBeyondTheLimit) {
    EXPECT_EQ(mostPoints(example()), limits::kControlPoints - 1);
    const Points many(limits::kControlPoints, {1, 2});
    EXPECT_EQ(mostPoints(withPointsAdded(example(), many)), limits::kControlPoints - 1);
}

TEST(SubdivisionEdits, multiplicityLeavesWithItsPointAndTheBlossomLosesItsLast) {
    const auto [curve, map] = withPointsRemoved(example(), {1});
    EXPECT_EQ(curve.points, (Points{{0, 0}, {3, 1}}));
    EXPECT_EQ(curve.multiplicity, (std::vector{1, 1}));
    EXPECT_EQ(curve.blossom, (std::vector<double>{0}));
    EXPECT_EQ(map(1), IndexMap::kGone);
    EXPECT_EQ(map(2), 1);
}

TEST(SubdivisionEdits, multiplicityRaisesTheDegreeOfTheBlossom) {
    EXPECT_EQ(withMultiplicity(example(), 0, 3).blossom, (std::vector<double>{0, 0.5, 1, 0.25, 0.25}));
    EXPECT_EQ(withMultiplicity(example(), 1, 1).blossom, (std::vector<double>{0, 0.5}));
    EXPECT_EQ(withMultiplicity(example(), 1, 5).multiplicity, (std::vector{1, 5, 1}));
}

TEST(SubdivisionEdits, reversedTurnsEverythingRound) {
    const auto [curve, map] = reversed(example());
    EXPECT_EQ(curve.points, (Points{{3, 1}, {1, 2}, {0, 0}}));
    EXPECT_EQ(curve.multiplicity, (std::vector{1, 2, 1}));
    EXPECT_EQ(curve.t, 0.75);
    EXPECT_EQ(curve.blossom, (std::vector<double>{1, 0.5, 0}));
    EXPECT_EQ(map(0), 2);
}

TEST(SubdivisionEdits, reversedKeepsNumbersWithinTheirRanges) {
    SubdivisionCurve curve = example();
    curve.t = 1e-300;
    curve.blossom = {-limits::kNumber, 0, limits::kNumber};
    const SubdivisionCurve turned = reversed(curve).curve;
    EXPECT_LT(turned.t, 1);
    EXPECT_EQ(turned.blossom->front(), limits::kNumber);
}

TEST(SubdivisionEdits, countTheControlPointsNotThePoints) {
    SubdivisionCurve curve = example();
    curve.levels = 3;
    EXPECT_EQ(pointCount(curve), 3u);
    EXPECT_EQ(derivedPointCount(curve), 32u);
    EXPECT_EQ(mostPoints(curve), 200u);
    EXPECT_EQ(mostMultiplicity(curve, std::array{1}), 199);
    curve.levels = 16; // 30 * 2^16 = 1,966,080, 31 * 2^16 = 2,031,616
    EXPECT_EQ(mostPoints(curve), 29u);
    EXPECT_EQ(mostMultiplicity(curve, std::array{1}), 28);
    EXPECT_EQ(mostLevels(30), 16);
    EXPECT_EQ(mostLevels(31), 15);
    EXPECT_EQ(mostLevels(201), 13);
}

TEST(SubdivisionEdits, ofACurveBeyondItsLimitsAllowNoMore) {
    SubdivisionCurve curve; // incomplete: its counts are not checked when it is read
    curve.points = {{0, 0}};
    curve.multiplicity = {201};
    curve.levels = 16;
    EXPECT_EQ(mostPoints(curve), 1u);
    EXPECT_EQ(derivedPointCount(curve), 0u);
}

TEST(SubdivisionEdits, everyPointHasOneGrip) {
    const std::vector<Grip> all = grips(example());
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[1], (Grip{{GripKind::point, 1}, {1, 2}}));
}

TEST(SubdivisionEdits, namedGripsMoveTogetherOnceAndStrangersNot) {
    const std::vector<GripId> ids{
        {GripKind::point, 2}, {GripKind::point, 0}, {GripKind::point, 0}, {GripKind::point, 9}, {GripKind::middle, 1}};
    EXPECT_EQ(withGripsMoved(example(), ids, {1, -1}).points, (Points{{1, -1}, {1, 2}, {4, 0}}));
}

TEST(SubdivisionEdits, settersChangeTheirOwnValueOnly) {
    SubdivisionCurve curve = example();
    EXPECT_EQ(withT(curve, 0.5).t, 0.5);
    EXPECT_EQ(withLevels(curve, 4).levels, 4);
    EXPECT_EQ(withBlossom(curve, {}).blossom, std::nullopt);
    EXPECT_EQ(withBlossom(curve, {{1, 2, 3}}).blossom, (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(withT(withT(curve, 0.5), 0.25), curve);
}

RC_GTEST_PROP(SubdivisionEdits, keepAllCountsValid, ()) {
    SubdivisionCurve curve = *anySubdivision();
    for (int i = 0; i < 12; ++i) {
        const int count = static_cast<int>(curve.points.size());
        const int index = count == 0 ? 0 : *rc::gen::inRange(0, count);
        switch (count == 0 ? 0 : *rc::gen::inRange(0, 4)) {
        case 0:
            curve = withPointAdded(curve, *anyPoint()).curve;
            break;
        case 1:
            curve = withPointsRemoved(curve, {index}).curve;
            break;
        case 2:
            curve = withMultiplicity(curve, index, *rc::gen::inRange(1, 5));
            break;
        default:
            curve = reversed(curve).curve;
        }
        RC_ASSERT(hasValidCounts(curve));
    }
}

RC_GTEST_PROP(SubdivisionEdits, reversedTwiceIsTheSame, ()) {
    const SubdivisionCurve curve = *anySubdivision();
    RC_ASSERT(reversed(reversed(curve).curve).curve == curve);
}

RC_GTEST_PROP(SubdivisionEdits, reversedIsTheSameFigureFromTheOtherEnd, ()) {
    const SubdivisionCurve curve = *anySubdivision(4);
    const Subdivision one = subdivide(curve);
    const Subdivision other = subdivide(reversed(curve).curve);
    const double small = 1e-12 * (diagonal(boxOf(curve.points)) + 1);
    RC_ASSERT(distance(one.triangle.back().front(), other.triangle.back().front()) <= small);
    RC_ASSERT(length(one.derivative + other.derivative) <= static_cast<double>(one.polygon.size()) * small);
    if (curve.blossom)
        RC_ASSERT(distance(*one.blossom, *other.blossom) <=
                  std::pow(3, static_cast<double>(curve.blossom->size())) * small);
}

RC_GTEST_PROP(SubdivisionEdits, removingFollowsTheMap, ()) {
    const SubdivisionCurve curve = *anySubdivision();
    std::vector<int> gone;
    for (int i = 0; i < static_cast<int>(curve.points.size()); ++i)
        if (*rc::gen::arbitrary<bool>())
            gone.push_back(i);
    const auto [left, map] = withPointsRemoved(curve, gone);
    RC_ASSERT(left.points.size() + gone.size() == curve.points.size());
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const int index = map(static_cast<int>(i));
        if (index == IndexMap::kGone)
            continue;
        RC_ASSERT(left.points[static_cast<std::size_t>(index)] == curve.points[i]);
        RC_ASSERT(left.multiplicity[static_cast<std::size_t>(index)] == curve.multiplicity[i]);
    }
}

RC_GTEST_PROP(SubdivisionEdits, dividedAtTheCutAreTheTwoHalves, ()) {
    const SubdivisionCurve curve = *test::anySubdivision();
    const auto parts = dividedAtCut(curve);
    RC_ASSERT(parts.has_value() == !isIncomplete(curve));
    if (!parts)
        return;
    const Subdivision cut = subdivide(curve);
    RC_ASSERT((*parts)[0].points == cut.halves.left);
    RC_ASSERT((*parts)[1].points == cut.halves.right);
    for (const SubdivisionCurve& part : *parts) {
        RC_ASSERT(part.multiplicity == std::vector<int>(part.points.size(), 1));
        RC_ASSERT(!part.blossom);
        RC_ASSERT(part.t == curve.t && part.levels == curve.levels && part.style == curve.style);
    }
}

} // namespace
} // namespace kriva
