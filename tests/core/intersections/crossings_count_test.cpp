#include "core/intersections/crossings.h"
#include "tests/support/data_sets.h"
#include "tests/support/long_run.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

/// How often the open spline through the first points of a data set crosses itself. No three passes meet in any.
std::size_t crossingsThrough(const Points& points) {
    const std::vector<Points> spline = test::catmullRom(points);
    const SegmentChain chain{spline, false};
    const Crossings found = findCrossings({&chain, 1});
    EXPECT_EQ(found.overlaps.size(), 0U);
    for (const Crossing& place : found.places)
        EXPECT_EQ(place.passes.size(), 2U);
    return found.places.size();
}

// The counts are those of a program that halves both segments until their boxes are apart, or the cones of their
// tangents and Newton's method meets a crossing, and that knows loops by the closed form of the double point.

TEST(CrossingsCount, ofLongSegmentsIsExact) {
    EXPECT_EQ(crossingsThrough(test::randomPoints(46, 10)), 5U);
    EXPECT_EQ(crossingsThrough(test::randomPoints(46, 100)), 1026U);
    if (test::isLongRun()) {
        EXPECT_EQ(crossingsThrough(test::randomPoints(46, 1000)), 112'141U);
    }
}

TEST(CrossingsCount, ofShortSegmentsIsExact) {
    EXPECT_EQ(crossingsThrough(test::randomWalk(10)), 1U);
    EXPECT_EQ(crossingsThrough(test::randomWalk(100)), 95U);
    EXPECT_EQ(crossingsThrough(test::randomWalk(1000)), 983U);
    if (test::isLongRun()) {
        EXPECT_EQ(crossingsThrough(test::randomWalk(10'000)), 24'357U);
    }
}

} // namespace
} // namespace kriva
