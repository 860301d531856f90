#include "core/geometry/hull.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace kriva {
namespace {

TEST(ConvexHull, ofASquareWithPointsInsideAndOnItsSides) {
    const Points points{{2, 2}, {0, 0}, {1, 0}, {2, 0}, {1, 1}, {0, 2}, {0, 1}, {0, 0}};
    EXPECT_EQ(convexHull(points), (Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

TEST(ConvexHull, ofFewOrCollinearPoints) {
    EXPECT_TRUE(convexHull(Points{}).empty());
    EXPECT_EQ(convexHull(Points(3, Point{1, 2})), (Points{{1, 2}}));
    EXPECT_EQ(convexHull(Points{{3, 3}, {1, 1}, {2, 2}}), (Points{{1, 1}, {3, 3}}));
    EXPECT_EQ(convexHull(Points{{1, 3}, {1, 1}, {1, 2}}), (Points{{1, 1}, {1, 3}}));
}

TEST(ConvexHull, keepsABarelyBentCorner) {
    // The products differ in the last place only.
    const Points points{{0, 0}, {134217729, 134217728}, {268435457, 268435455}};
    EXPECT_EQ(convexHull(points).size(), 3U);
}

RC_GTEST_PROP(ConvexHull, isConvexAndHoldsAllPoints, ()) {
    const Points points = *test::anyCurve(2, 40);
    const Points hull = convexHull(points);
    RC_PRE(hull.size() >= 3U);
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point a = hull[i];
        const Point b = hull[(i + 1) % hull.size()];
        const Point c = hull[(i + 2) % hull.size()];
        // Multiples of 1/64 up to 1000: these products are exact.
        RC_ASSERT(cross(b - a, c - a) > 0);
        for (const Point p : points)
            RC_ASSERT(cross(b - a, p - a) >= 0);
        RC_ASSERT(std::ranges::find(points, a) != points.end());
    }
}

} // namespace
} // namespace kriva
