#include "core/bezier/evaluate.h"
#include "core/sheets/spline/editing/chain_edits.h"
#include "core/sheets/spline/editing/joins.h"
#include "core/sheets/spline/spline.h"
#include "tests/core/sheets/spline/spline_values.h"

namespace kriva {
namespace {

using test::anySpline;
using test::curveThrough;
using test::farthest;
using test::heldKnot;
using Join = SplineKnot::Join;
using Rule = SplineCurve::Rule;

double anyInnerParameter() {
    return *rc::gen::inRange(1, 16) / 16.0;
}

SplineCurve anyWithHandles() {
    SplineCurve curve = anySpline();
    curve.degree = *rc::gen::inRange(3, 6);
    return repaired(curve);
}

RC_GTEST_PROP(KnotInserted, keepsTheShape, ()) {
    const SplineCurve curve = anyWithHandles();
    const std::vector<Points> before = solveSpline(curve).segments;
    const int segment = *rc::gen::inRange(0, static_cast<int>(before.size()));
    const double t = anyInnerParameter();
    const Edited<SplineCurve> edited = withKnotInserted(curve, segment, t);
    const std::vector<Points> after = solveSpline(edited.curve).segments;
    RC_ASSERT(after.size() == before.size() + 1);
    const auto cut = static_cast<std::size_t>(segment);
    for (std::size_t i = 0; i < before.size(); ++i)
        if (i != cut)
            RC_ASSERT(farthest({after[i < cut ? i : i + 1]}, {before[i]}) <= 1e-8);
    for (const double u : {0.25, 0.5, 0.75}) {
        RC_ASSERT(distance(evaluate(after[cut], u), evaluate(before[cut], u * t)) <= 1e-8);
        RC_ASSERT(distance(evaluate(after[cut + 1], u), evaluate(before[cut], t + u * (1 - t))) <= 1e-8);
    }
    RC_ASSERT(repaired(edited.curve) == edited.curve);
}

RC_GTEST_PROP(KnotInserted, leavesAnyOtherKnotAsItWas, ()) {
    const SplineCurve curve = anyWithHandles();
    const int segment = *rc::gen::inRange(0, static_cast<int>(segmentCount(curve)));
    const Edited<SplineCurve> edited = withKnotInserted(curve, segment, anyInnerParameter());
    const int count = static_cast<int>(curve.knots.size());
    for (int old = 0; old < count; ++old) {
        const SplineKnot& before = curve.knots[static_cast<std::size_t>(old)];
        const SplineKnot& after = edited.curve.knots[static_cast<std::size_t>(edited.map(old))];
        RC_ASSERT(after.at == before.at);
        if (old != segment && old != (segment + 1) % count)
            RC_ASSERT(after == before);
        else
            RC_ASSERT(after.join == (before.join == Join::corner ? Join::corner : Join::smooth));
    }
}

TEST(KnotInserted, onAParabolaLiesOnTheOldCurve) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {2, 3}, {4, 4}}, false, 2);
    const Edited<SplineCurve> edited = withKnotInserted(curve, 1, 0.5);
    ASSERT_EQ(edited.curve.knots.size(), 4u);
    EXPECT_EQ(edited.curve.knots[2].at, evaluate(solveSpline(curve).segments[1], 0.5));
    EXPECT_TRUE(isAutomatic(edited.curve.knots[2]));
}

TEST(KnotInserted, innerPointsBehindItShift) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 3}, {6, 0}, {9, 3}}, false, 4);
    curve.inner = {{0, {{1, 2}}}, {1, {{4, 2}}}, {2, {{8, 2}}}};
    const std::map<int, Points> inner = withKnotInserted(curve, 1, 0.5).curve.inner;
    EXPECT_EQ(inner.size(), 4u);
    EXPECT_EQ(inner.at(0), curve.inner.at(0));
    EXPECT_EQ(inner.at(3), curve.inner.at(2));
}

RC_GTEST_PROP(Degree, fourToFiveKeepsTheShape, ()) {
    SplineCurve curve = anySpline();
    curve.degree = 4;
    curve = repaired(curve);
    const std::vector<Points> before = solveSpline(curve).segments;
    const SplineCurve raised = withDegree(curve, 5);
    RC_ASSERT(raised.inner.size() == curve.inner.size());
    const std::vector<Points> after = solveSpline(raised).segments;
    for (std::size_t i = 0; i < before.size(); ++i)
        for (const double t : {0.125, 0.5, 0.75})
            RC_ASSERT(distance(evaluate(after[i], t), evaluate(before[i], t)) <= 1e-9);
}

TEST(Degree, fiveToFourDropsInnerPoints) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 3}}, false, 5);
    curve.inner[0] = {{1, 2}, {2, 1}};
    EXPECT_TRUE(withDegree(curve, 4).inner.empty());
    EXPECT_EQ(withDegree(withDegree(curve, 3), 5), curve);
}

TEST(Degree, leavingParabolasPlacesTheHandlesThatJoinsNeed) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 3}, {6, 0}}, false, 2);
    curve.knots[1].join = Join::corner;
    const SplineCurve cubic = withDegree(curve, 3);
    EXPECT_EQ(solveSpline(cubic), solveSpline(curveThrough(Rule::mirror, {{0, 0}, {3, 3}, {6, 0}})));
    EXPECT_TRUE(cubic.knots[1].in && cubic.knots[1].out);
}

TEST(Closed, openingDropsTheInnerPointsOfTheClosingSegment) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 3}, {6, 0}}, true, 4);
    curve.inner = {{0, {{1, 1}}}, {2, {{2, 2}}}};
    EXPECT_EQ(withClosed(curve, false).inner, (std::map<int, Points>{{0, {{1, 1}}}}));
}

TEST(Closed, closingCompletesTheHandlesOfTheEnds) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 3}, {6, 0}});
    curve.knots[0] = heldKnot({0, 0}, Join::smooth, {}, Point{1, 0});
    EXPECT_EQ(withClosed(curve, true).knots[0].in, (Point{-1, 0}));
}

RC_GTEST_PROP(SegmentPulled, takesThePointAlong, ()) {
    const SplineCurve curve = anyWithHandles();
    const int segment = *rc::gen::inRange(0, static_cast<int>(segmentCount(curve)));
    const double t = anyInnerParameter();
    const Vector by = *test::anyPoint() - Point{};
    const auto i = static_cast<std::size_t>(segment);
    const Point before = evaluate(solveSpline(curve).segments[i], t);
    const Point after = evaluate(solveSpline(withSegmentPulled(curve, segment, t, by)).segments[i], t);
    RC_ASSERT(distance(after, before + by) <= 1e-7);
}

TEST(SegmentPulled, leavesParabolasAlone) {
    const SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 3}}, false, 2);
    EXPECT_EQ(withSegmentPulled(curve, 0, 0.5, {1, 1}), curve);
}

TEST(PointInsertedBehind, cutsTheSegmentBehindTheKnotOrTheLongest) {
    const SplineCurve open = curveThrough(Rule::mirror, {{0, 0}, {1, 0}, {9, 0}, {10, 0}});
    const auto newKnot = [](const SplineCurve& curve, std::optional<int> knot) {
        const std::optional<Edited<SplineCurve>> edited = withPointInsertedBehind(curve, knot);
        int index = 0;
        while (index < static_cast<int>(curve.knots.size()) && edited->map(index) == index)
            ++index;
        return index;
    };
    EXPECT_EQ(newKnot(open, {}), 2);
    EXPECT_EQ(newKnot(open, 0), 1);
    EXPECT_EQ(newKnot(open, 3), 3) << "before the last knot of an open chain";
    EXPECT_EQ(newKnot(withClosed(open, true), 3), 4);
    EXPECT_FALSE(withPointInsertedBehind(curveThrough(Rule::mirror, {{0, 0}}), {}));
}

} // namespace
} // namespace kriva
