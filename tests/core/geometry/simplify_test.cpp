#include "core/geometry/segment.h"
#include "core/geometry/simplify.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace kriva {
namespace {

TEST(Simplified, keepsTheEndsOfAStraightLine) {
    const Points line{{0, 0}, {1, 0.01}, {2, -0.01}, {3, 0}};
    EXPECT_EQ(simplified(line, {0.1}), (Points{{0, 0}, {3, 0}}));
    EXPECT_EQ(simplified(line, {0}), line);
}

TEST(Simplified, leavesAloneWhatHasNothingToLeaveOut) {
    EXPECT_TRUE(simplified(Points{}, {1}).empty());
    EXPECT_EQ(simplified(Points{{1, 2}}, {1}), (Points{{1, 2}}));
    EXPECT_EQ(simplified(Points{{1, 2}, {1, 2}}, {1}), (Points{{1, 2}, {1, 2}}));
}

TEST(Simplified, keepsAPlaceWhereThePolylineTurnsBack) {
    EXPECT_EQ(simplified(Points{{0, 0}, {5, 0}, {10, 0}, {4, 0}}, {0.1}), (Points{{0, 0}, {10, 0}, {4, 0}}));
}

TEST(Simplified, takesFewVerticesForACircleOfMany) {
    Points circle;
    for (int i = 0; i <= 10'000; ++i)
        circle.push_back({std::cos(i * 2e-4 * M_PI), std::sin(i * 2e-4 * M_PI)});
    // A chord of this sagitta spans 2 acos(1 - 0.001): 71 of them go round, the cone takes up to twice as many.
    EXPECT_LT(simplified(circle, {0.001}).size(), 142U);
}

RC_GTEST_PROP(Simplified, keepsTheEndsAndPassesEachVertexLeftOut, ()) {
    const Points polyline = *test::anyCurve(2, 40);
    const double tolerance = *rc::gen::element(0.0, 1.0, 30.0, 300.0);
    const Points kept = simplified(polyline, {tolerance});
    RC_ASSERT(kept.front() == polyline.front());
    RC_ASSERT(kept.back() == polyline.back());
    std::size_t next = 1; // of the kept vertices
    for (const Point p : polyline) {
        if (p == kept[next] && next + 1 < kept.size())
            ++next;
        double least = distanceToSegment(p, kept[next - 1], kept[next]);
        if (next > 1)
            least = std::min(least, distanceToSegment(p, kept[next - 2], kept[next - 1]));
        RC_ASSERT(least <= tolerance + 1e-9);
    }
}

} // namespace
} // namespace kriva
