#include "core/sheets/spline/editing/joins.h"
#include "tests/core/sheets/spline/spline_values.h"

namespace kriva {
namespace {

using test::anySpline;
using test::curveThrough;
using test::farthest;
using test::heldKnot;
using Join = SplineKnot::Join;
using Rule = SplineCurve::Rule;

double angleSine(Vector a, Vector b) {
    return cross(a, b) / (length(a) * length(b));
}

RC_GTEST_PROP(KnotHandles, areThoseOfTheCubics, ()) {
    SplineCurve curve = anySpline();
    curve.degree = 3;
    const std::vector<KnotHandles> handles = knotHandles(curve);
    const std::vector<Points> cubics = solveSpline(curve).segments;
    for (std::size_t i = 0; i < handles.size(); ++i) {
        RC_ASSERT(handles[i].out.has_value() == hasSegmentAfter(curve, i));
        RC_ASSERT(handles[i].in.has_value() == hasSegmentBefore(curve, i));
        if (handles[i].out)
            RC_ASSERT(distance(*handles[i].out, cubics[i][1]) <= 1e-12);
        if (handles[i].in)
            RC_ASSERT(distance(*handles[i].in, cubics[(i + cubics.size() - 1) % cubics.size()][2]) <= 1e-12);
    }
}

TEST(KnotHandles, parabolasAndIncompleteCurvesHaveNone) {
    EXPECT_EQ(knotHandles(curveThrough(Rule::mirror, {{0, 0}, {1, 1}, {2, 0}}, false, 2)), std::vector<KnotHandles>(3));
    EXPECT_EQ(knotHandles(curveThrough(Rule::mirror, {{0, 0}, {1, 1}}, true)), std::vector<KnotHandles>(2));
}

TEST(WithHandleAt, makesAnAutomaticKnotSymmetric) {
    const SplineKnot knot = withHandleAt(heldKnot({1, 1}, Join::automatic, {}, {}), HandleSide::out, {3, 2});
    EXPECT_EQ(knot, heldKnot({1, 1}, Join::symmetric, Point{-1, 0}, Point{3, 2}));
}

TEST(WithHandleAt, mirrorsTheOtherHandleOfASymmetricKnot) {
    const SplineKnot knot = heldKnot({1, 1}, Join::symmetric, Point{0, 0}, Point{2, 2});
    EXPECT_EQ(withHandleAt(knot, HandleSide::in, {1, -2}).out, (Point{1, 4}));
}

TEST(WithHandleAt, turnsTheOtherHandleOfASmoothKnotAndKeepsItsLength) {
    const SplineKnot knot = heldKnot({1, 1}, Join::smooth, Point{-4, 1}, Point{2, 1});
    const SplineKnot turned = withHandleAt(knot, HandleSide::out, {1, 3});
    EXPECT_EQ(turned.in, (Point{1, -4}));
    EXPECT_EQ(withHandleAt(knot, HandleSide::out, {1, 1}).in, knot.in);
}

TEST(WithHandleAt, leavesTheOtherHandleOfACornerAlone) {
    const SplineKnot knot = heldKnot({1, 1}, Join::corner, Point{-4, 1}, Point{2, 1});
    EXPECT_EQ(withHandleAt(knot, HandleSide::out, {1, 3}), heldKnot({1, 1}, Join::corner, Point{-4, 1}, Point{1, 3}));
}

RC_GTEST_PROP(WithJoin, aCornerKeepsTheShape, ()) {
    const SplineCurve curve = anySpline();
    const int knot = *rc::gen::inRange(0, static_cast<int>(curve.knots.size()));
    const SplineCurve changed = withJoin(curve, std::vector{knot}, Join::corner);
    RC_ASSERT(changed.knots[static_cast<std::size_t>(knot)].join == Join::corner);
    RC_ASSERT(farthest(solveSpline(changed).segments, solveSpline(curve).segments) <= 1e-9);
}

RC_GTEST_PROP(WithJoin, symmetricAndSmoothKeepTheirPromise, (bool symmetric)) {
    SplineCurve curve = anySpline();
    curve.degree = std::max(curve.degree, 3);
    const int index = *rc::gen::inRange(0, static_cast<int>(curve.knots.size()));
    const Join join = symmetric ? Join::symmetric : Join::smooth;
    const SplineCurve changed = withJoin(curve, std::vector{index}, join);
    const SplineKnot& knot = changed.knots[static_cast<std::size_t>(index)];
    if (!knot.in || !knot.out) // an open end has nothing to tie
        return;
    const Vector in = knot.at - *knot.in;
    const Vector out = *knot.out - knot.at;
    if (symmetric)
        RC_ASSERT(length(in - out) <= 1e-12);
    else if (length(in) > 1e-6 && length(out) > 1e-6)
        RC_ASSERT(std::abs(angleSine(in, out)) <= 1e-6 && dot(in, out) > 0);
}

TEST(WithJoin, smoothKeepsTheLengthsOfBothHandles) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {5, 5}, {9, 0}});
    curve.knots[1] = heldKnot({5, 5}, Join::corner, Point{5, 1}, Point{8, 5});
    const SplineCurve changed = withJoin(curve, std::vector{1}, Join::smooth);
    EXPECT_NEAR(distance(*changed.knots[1].in, {5, 5}), 4, 1e-14);
    EXPECT_NEAR(distance(*changed.knots[1].out, {5, 5}), 3, 1e-14);
    EXPECT_NEAR(angleSine(*changed.knots[1].out - Point{5, 5}, {3, 4}), 0, 1e-14);
}

TEST(WithJoin, automaticGivesUpStoredHandles) {
    SplineCurve curve = curveThrough(Rule::natural, {{0, 0}, {5, 5}, {9, 0}});
    const SplineCurve plain = curve;
    curve.knots[1] = heldKnot({5, 5}, Join::corner, Point{5, 1}, Point{8, 5});
    EXPECT_EQ(withJoin(curve, std::vector{1}, Join::automatic), plain);
}

TEST(Repaired, placesTheHandlesThatSegmentsMiss) {
    SplineCurve curve = curveThrough(Rule::natural, {{0, 0}, {3, 3}, {6, 0}});
    curve.knots[0] = heldKnot({0, 0}, Join::smooth, Point{-1, -1}, {});
    curve.knots[1].join = Join::corner;
    const SplineCurve whole = repaired(curve);
    EXPECT_EQ(whole.knots[0].out, (Point{1, 1})); // the mirror image of the other
    ASSERT_TRUE(whole.knots[1].in && whole.knots[1].out);
    EXPECT_NE(*whole.knots[1].in, (Point{3, 3}));
    EXPECT_FALSE(whole.knots[2].in);
    EXPECT_EQ(repaired(whole), whole);
}

TEST(Repaired, dropsInnerPointsThatBelongToNoSegment) {
    SplineCurve curve = curveThrough(Rule::natural, {{0, 0}, {3, 3}, {6, 0}}, false, 4);
    curve.inner = {{0, {{1, 1}}}, {1, {{1, 1}, {2, 2}}}, {2, {{1, 1}}}};
    EXPECT_EQ(repaired(curve).inner, (std::map<int, Points>{{0, {{1, 1}}}}));
    curve.degree = 3; // no inner points count there
    EXPECT_EQ(repaired(curve), curve);
}

} // namespace
} // namespace kriva
