#include "core/bezier/evaluate.h"
#include "core/bezier/nearest.h"
#include "core/sheets/spline/editing/chain_edits.h"
#include "core/sheets/spline/editing/joins.h"
#include "core/sheets/spline/spline.h"
#include "tests/core/sheets/spline/spline_values.h"

namespace kriva {
namespace {

using test::anySpline;
using test::curveThrough;
using test::farthest;
using Join = SplineKnot::Join;
using Rule = SplineCurve::Rule;

SplineCurve anyChainWithHandles() {
    SplineCurve curve = anySpline();
    curve.degree = *rc::gen::inRange(3, 6);
    return repaired(curve);
}

// Smooth and well away from cusps, where one cubic is determined by its shape.
TEST(RefittedRemoval, takesBackAnInsertedKnot) {
    for (const Rule rule : {Rule::mirror, Rule::natural, Rule::clamped, Rule::catmullRom})
        for (const bool closed : {false, true})
            for (const double t : {0.2, 0.5, 0.7}) {
                const SplineCurve curve = curveThrough(rule, {{0, 0}, {4, 3}, {9, 1}, {7, -4}}, closed);
                const SplineCurve inserted = withKnotInserted(curve, 1, t).curve;
                const Refitted<SplineCurve> removal = withPointsRemovedRefitted(inserted, {2});
                EXPECT_LE(farthest(solveSpline(removal.edited.curve).segments, solveSpline(curve).segments), 1e-9);
                ASSERT_TRUE(removal.deviation);
                EXPECT_LE(*removal.deviation, 1e-9);
            }
}

RC_GTEST_PROP(RefittedRemoval, leavesTheRestOfTheCurveWhereItIs, ()) {
    const SplineCurve curve = anyChainWithHandles();
    const int count = static_cast<int>(curve.knots.size());
    const int gone = *rc::gen::inRange(0, count);
    const Refitted<SplineCurve> removal = withPointsRemovedRefitted(curve, {gone});
    if (isIncomplete(removal.edited.curve))
        return;
    const std::vector<Points> before = solveSpline(curve).segments;
    const std::vector<Points> after = solveSpline(removal.edited.curve).segments;
    for (int i = 0; i < static_cast<int>(before.size()); ++i)
        if (i != gone && (i + 1) % count != gone) {
            const auto now = static_cast<std::size_t>(removal.edited.map(i));
            RC_ASSERT(farthest({after[now]}, {before[static_cast<std::size_t>(i)]}) <= 1e-8);
        }
    RC_ASSERT(repaired(removal.edited.curve) == removal.edited.curve);
}

RC_GTEST_PROP(RefittedRemoval, deviatesNoMoreThanItTells, ()) {
    const SplineCurve curve = anyChainWithHandles();
    const int gone = *rc::gen::inRange(1, static_cast<int>(curve.knots.size()) - 1);
    const Refitted<SplineCurve> removal = withPointsRemovedRefitted(curve, {gone});
    if (!removal.deviation)
        return;
    const auto old = static_cast<std::size_t>(gone);
    const Points joined = solveSpline(removal.edited.curve).segments[old - 1];
    const std::vector<Points> before = solveSpline(curve).segments;
    for (const Points& segment : {before[old - 1], before[old]})
        for (const double t : {0.25, 0.5, 1.0})
            RC_ASSERT(nearest(joined, evaluate(segment, t)).distance <= *removal.deviation + 1e-6);
    // Handles no longer than a few times the way that they stand for: all coordinates are at most 1000.
    for (const Point p : joined)
        RC_ASSERT(distance(p, joined.front()) <= 1e5);
}

TEST(RefittedRemoval, changesTheShapeLessThanAPlainOne) {
    const SplineCurve curve = curveThrough(Rule::natural, {{0, 0}, {2, 3}, {5, 4}, {8, 3}, {10, 0}});
    const Points refitted = solveSpline(withPointsRemovedRefitted(curve, {2}).edited.curve).segments[1];
    const Points plain = solveSpline(withPointsRemoved(curve, {2}).curve).segments[1];
    EXPECT_LT(nearest(refitted, {5, 4}).distance, nearest(plain, {5, 4}).distance);
}

TEST(RefittedRemoval, keepsCorners) {
    SplineCurve curve = curveThrough(Rule::natural, {{0, 0}, {2, 3}, {5, 4}, {8, 3}});
    curve = withJoin(curve, std::vector{1}, Join::corner);
    const SplineCurve removed = withPointsRemovedRefitted(curve, {2}).edited.curve;
    EXPECT_EQ(removed.knots[1].join, Join::corner);
    EXPECT_EQ(removed.knots[2].join, Join::smooth);
}

TEST(RefittedRemoval, hasNothingToFitAtAnOpenEnd) {
    const SplineCurve curve = curveThrough(Rule::natural, {{0, 0}, {2, 3}, {5, 4}});
    EXPECT_FALSE(withPointsRemovedRefitted(curve, {2}).deviation);
    EXPECT_FALSE(withPointsRemovedRefitted(curve, {0, 1}).deviation);
}

TEST(RefittedRemoval, ofCoincidentKnotsIsExact) {
    const SplineCurve curve = curveThrough(Rule::natural, Points(4, {1, 2}));
    const Refitted<SplineCurve> removal = withPointsRemovedRefitted(curve, {1});
    EXPECT_EQ(removal.deviation, 0);
    EXPECT_EQ(solveSpline(removal.edited.curve).segments, std::vector<Points>(2, Points(4, {1, 2})));
}

TEST(RefittedRemoval, ofParabolasIsAPlainOne) {
    const SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {2, 3}, {5, 4}}, false, 2);
    EXPECT_EQ(withPointsRemovedRefitted(curve, {1}).edited.curve, withPointsRemoved(curve, {1}).curve);
}

} // namespace
} // namespace kriva
