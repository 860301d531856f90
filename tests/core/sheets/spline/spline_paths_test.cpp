#include "core/figure/figure.h"
#include "core/sheets/spline/spline.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

using Join = SplineKnot::Join;

std::vector<Join> joinsOf(const SplineCurve& curve) {
    std::vector<Join> joins;
    for (const SplineKnot& knot : curve.knots)
        joins.push_back(knot.join);
    return joins;
}

rc::Gen<Point> anyPlace() {
    return rc::gen::map(rc::gen::pair(rc::gen::inRange(-1000, 1000), rc::gen::inRange(-1000, 1000)),
                        [](const auto& xy) {
                            return Point{xy.first / 7.0, xy.second / 7.0};
                        });
}

RC_GTEST_PROP(SplineWithPath, hasTheCubicsOfThePathBitForBit, ()) {
    const int count = *rc::gen::inRange(1, 12);
    Points points = *rc::gen::container<Points>(static_cast<std::size_t>(3 * count + 1), anyPlace());
    for (int i = 0; i < count; ++i)
        RC_PRE(points[static_cast<std::size_t>(3 * i)] != points[static_cast<std::size_t>(3 * i + 3)]);
    const Path path{points, std::vector<int>(static_cast<std::size_t>(count), 3), false};
    const std::vector<Points> segments = segmentsOf(withPathAdded(SplineCurve{}, path));
    RC_ASSERT(chain(segments, false) == path);
}

TEST(SplineWithPath, keepsLinesStraightWithRetractedHandles) {
    const SplineCurve curve = withPathAdded(SplineCurve{}, polyline(Points{{0, 0}, {3, 0}, {3, 3}}));
    ASSERT_EQ(curve.knots.size(), 3);
    EXPECT_EQ(curve.knots[1], (SplineKnot{{3, 0}, Join::corner, Point{3, 0}, Point{3, 0}}));
    EXPECT_EQ(segmentsOf(curve).front(), (Points{{0, 0}, {0, 0}, {3, 0}, {3, 0}}));
}

TEST(SplineWithPath, tellsHowHandlesLie) {
    const Path path{
        {{0, 0}, {1, 1}, {2, 0}, {3, 0}, {4, 0}, {5, 5}, {6, 6}, {8, 8}, {9, 9}, {9, 9}, {10, 0}}, {3, 3, 2, 2}, false};
    EXPECT_EQ(joinsOf(withPathAdded(SplineCurve{}, path)),
              (std::vector{Join::corner, Join::symmetric, Join::smooth, Join::corner, Join::corner}));
}

TEST(SplineWithPath, closesAClosedPath) {
    const Path square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}, {1, 1, 1, 1}, true};
    const SplineCurve curve = withPathAdded(SplineCurve{}, square);
    EXPECT_TRUE(curve.closed);
    EXPECT_EQ(curve.knots.size(), 4);
    // Both handles of the first knot: the one in comes from the last piece.
    const Path drop{{{0, 0}, {2, 1}, {2, -1}, {3, 0}, {3, 3}, {-2, 3}, {0, 0}}, {3, 3}, true};
    const SplineCurve closed = withPathAdded(SplineCurve{}, drop);
    EXPECT_TRUE(closed.closed);
    EXPECT_EQ(closed.knots.size(), 3) << "a closed spline has three at least";
    EXPECT_EQ(segmentsOf(closed).size(), 3);
    EXPECT_EQ(segmentsOf(closed).front(), (Points{{0, 0}, {2, 1}, {2, -1}, {3, 0}}));
    EXPECT_EQ(segmentsOf(closed).back().back(), (Point{0, 0}));
    const SplineCurve behind = withPathAdded(closed, square);
    EXPECT_EQ(behind.knots.size(), closed.knots.size() + 5) << "behind other knots it is no loop";
}

TEST(SplineWithPath, leavesOutTheRoundingsOfAFile) {
    const Path path{{{0, 0}, {10, 0}, {10, 10}, {1e-7, 0}, {0, 0}}, {1, 1, 1, 1}, true};
    EXPECT_EQ(withPathAdded(SplineCurve{}, path).knots.size(), 3);
    const Path standing{{{0, 0}, {10, 0}, {10, 0}, {10, 10}}, {1, 1, 1}, false};
    EXPECT_EQ(withPathAdded(SplineCurve{}, standing).knots.size(), 3);
}

TEST(SplineWithPath, takesPointsAloneAsAutomaticKnots) {
    const SplineCurve curve = withPathAdded(SplineCurve{}, {{{0, 0}, {1, 1}, {2, 0}}, {}, false});
    EXPECT_EQ(joinsOf(curve), (std::vector(3, Join::automatic)));
}

} // namespace
} // namespace kriva
