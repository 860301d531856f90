#include "core/bezier/evaluate.h"
#include "core/bezier/flatten.h"
#include "core/bezier/nearest.h"
#include "core/geometry/box.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace kriva {
namespace {

double distanceToPolyline(Point p, const Points& vertices) {
    double least = distance(p, vertices.front());
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
        least = std::min(least, nearest(std::span(vertices).subspan(i, 2), p).distance);
    return least;
}

TEST(Flatten, aLineKeepsItsEndsAndAPointItself) {
    EXPECT_EQ(flattened(Points{{0, 0}, {0.1, 7}}, {1e-3}), (Points{{0, 0}, {0.1, 7}}));
    EXPECT_EQ(flattened(Points{{0, 0}, {1, 1}, {3, 3}, {4, 4}}, {1e-3}), (Points{{0, 0}, {4, 4}}));
    EXPECT_EQ(flattened(Points{{1, 2}}, {1e-3}), (Points{{1, 2}}));
    EXPECT_EQ(flattened(Points(4, Point{1, 2}), {1e-3}), Points(2, Point{1, 2}));
}

TEST(Flatten, followsALineThatTurnsBack) {
    const Points vertices = flattened(Points{{0, 0}, {4, 0}, {-4, 0}, {0, 0}}, {1e-3});
    const auto [left, right] = std::ranges::minmax(vertices, {}, &Point::x);
    EXPECT_NEAR(right.x, 4 / std::sqrt(12.0), 1e-3);
    EXPECT_NEAR(left.x, -4 / std::sqrt(12.0), 1e-3);
}

TEST(Flatten, endsAtZeroTolerance) {
    EXPECT_LT(flattened(Points{{0, 0}, {1, 2}, {3, 2}, {4, 0}}, {0}).size(), 40000U);
    EXPECT_LT(flattened(Points{{0, 0}, {1, 1}, {0, 1}, {1, 0}}, {0}).size(), 40000U);
}

RC_GTEST_PROP(Flatten, staysWithinTheToleranceOnBothSides, ()) {
    const Points curve = *test::anyCurve(1, 8);
    const double tolerance = *rc::gen::element(100.0, 10.0);
    const Points vertices = flattened(curve, {tolerance});
    RC_ASSERT(vertices.front() == curve.front());
    RC_ASSERT(vertices.back() == curve.back());
    for (int i = 0; i <= 100; ++i)
        RC_ASSERT(distanceToPolyline(evaluate(curve, i / 100.0), vertices) <= tolerance * (1 + 1e-9));
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
        for (const double u : {0.0, 0.3, 0.5})
            RC_ASSERT(nearest(curve, lerp(vertices[i], vertices[i + 1], u)).distance <= tolerance * (1 + 1e-9));
}

} // namespace
} // namespace kriva
