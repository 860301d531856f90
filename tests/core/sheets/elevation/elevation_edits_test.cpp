#include "core/bezier/elevate.h"
#include "core/curve/limits.h"
#include "core/sheets/elevation/elevation.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

ElevationCurve arch() {
    ElevationCurve curve;
    curve.name = "arch";
    curve.points = {{0, 0}, {1, 2}, {3, 1}};
    curve.times = 4;
    return curve;
}

TEST(ElevationEdits, aNewPointStandsAtTheEnd) {
    const auto [curve, map] = withPointAdded(arch(), {5, 5});
    EXPECT_EQ(curve.points, (Points{{0, 0}, {1, 2}, {3, 1}, {5, 5}}));
    EXPECT_EQ(curve.times, 4);
    EXPECT_EQ(map(2), 2);
}

TEST(ElevationEdits, removingFollowsTheMap) {
    const auto [curve, map] = withPointsRemoved(arch(), {0, 2});
    EXPECT_EQ(curve.points, (Points{{1, 2}}));
    EXPECT_EQ(map.newIndex, (std::vector{IndexMap::kGone, 0, IndexMap::kGone}));
}

TEST(ElevationEdits, reversedRunsFromTheOtherEnd) {
    const auto [curve, map] = reversed(arch());
    EXPECT_EQ(curve.points, (Points{{3, 1}, {1, 2}, {0, 0}}));
    EXPECT_EQ(map.newIndex, (std::vector{2, 1, 0}));
    EXPECT_EQ(reversed(curve).curve, arch());
}

TEST(ElevationEdits, everyPointHasOneGrip) {
    const std::vector<Grip> all = grips(arch());
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[2], (Grip{{GripKind::point, 2}, {3, 1}}));
}

TEST(ElevationEdits, namedGripsMoveTogetherOnceAndStrangersNot) {
    const std::vector<GripId> ids{{GripKind::point, 2},
                                  {GripKind::point, 0},
                                  {GripKind::point, 2},
                                  {GripKind::point, -1},
                                  {GripKind::outHandle, 1}};
    EXPECT_EQ(withGripsMoved(arch(), ids, {1, -1}).points, (Points{{1, -1}, {1, 2}, {4, 0}}));
}

TEST(ElevationEdits, countThePointsOfTheElevatedPolygon) {
    EXPECT_EQ(pointCount(arch()), 3u);
    EXPECT_EQ(derivedPointCount(arch()), 7u);
    EXPECT_FALSE(pointLimitError(arch()));
    EXPECT_EQ(pointLimitError(withPointsAdded(arch(), Points(limits::kControlPoints))).value().numbers,
              (std::vector<double>{limits::kControlPoints, limits::kControlPoints + 3}));
    EXPECT_EQ(derivedPointCount(withPointsRemoved(arch(), {0, 1}).curve), 0u);
}

TEST(ElevationEdits, theElevatedPolygonBecomesTheControlPolygon) {
    const ElevationCurve taken = withElevatedPolygon(arch());
    EXPECT_EQ(taken.points, elevated(arch().points, 4));
    EXPECT_EQ(taken.times, 0);
    EXPECT_EQ(taken.name, "arch");
    EXPECT_FALSE(canTakeElevatedPolygon(taken)) << "it is not elevated";
    ElevationCurve large = arch();
    large.times = static_cast<int>(limits::kControlPoints) - 3;
    EXPECT_TRUE(canTakeElevatedPolygon(large));
    ++large.times;
    EXPECT_FALSE(canTakeElevatedPolygon(large)) << "too many points";
}

TEST(ElevationEdits, oneDegreeLessUndoesAnElevation) {
    ElevationCurve raised = arch();
    raised.points = elevated(raised.points, 1);
    const auto reduced = withDegreeReduced(raised);
    ASSERT_TRUE(reduced);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_LT(distance(reduced->edited.curve.points[i], arch().points[i]), 1e-14);
    EXPECT_LT(*reduced->deviation, 1e-14);
    EXPECT_EQ(reduced->edited.map.newIndex, (std::vector{0, IndexMap::kGone, IndexMap::kGone, 2}));
    EXPECT_EQ(reduced->edited.curve.times, 4);
}

TEST(ElevationEdits, oneDegreeLessTellsHowFarTheCurveMoves) {
    const auto reduced = withDegreeReduced(arch()); // to the line between its ends
    ASSERT_TRUE(reduced);
    EXPECT_EQ(reduced->edited.curve.points, (Points{{0, 0}, {3, 1}}));
    EXPECT_NEAR(*reduced->deviation, std::hypot(0.25, 0.75), 1e-12) << "at t = 1/2, (b0 - 2 b1 + b2) / 4";
    EXPECT_FALSE(withDegreeReduced(reduced->edited.curve));
}

} // namespace
} // namespace kriva
