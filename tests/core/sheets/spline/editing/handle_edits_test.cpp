#include "core/sheets/spline/editing/handle_edits.h"
#include "core/sheets/spline/editing/joins.h"
#include "tests/core/sheets/spline/spline_values.h"

namespace kriva {
namespace {

using test::anySpline;
using test::curveThrough;
using test::heldKnot;
using Join = SplineKnot::Join;
using Rule = SplineCurve::Rule;

constexpr std::array kMiddle{1};

/// Three knots, the middle one, (5, 5), with these handles.
SplineCurve heldCurve(Join join, Point in, Point out) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {5, 5}, {10, 0}});
    curve.knots[1] = heldKnot({5, 5}, join, in, out);
    return curve;
}

std::vector<int> allKnots(const SplineCurve& curve) {
    std::vector<int> all;
    for (int i = 0; i < static_cast<int>(curve.knots.size()); ++i)
        all.push_back(i);
    return all;
}

TEST(HandleAlignment, turnsTheHandlesOfACornerAndLeavesItACorner) {
    const SplineKnot knot = withHandlesAligned(heldCurve(Join::corner, {5, 3}, {9, 5}), kMiddle).knots[1];
    EXPECT_EQ(knot.join, Join::corner);
    EXPECT_NEAR(cross(*knot.in - knot.at, *knot.out - knot.at), 0, 1e-14);
    EXPECT_LT(dot(*knot.in - knot.at, *knot.out - knot.at), 0);
    EXPECT_NEAR(distance(*knot.in, knot.at), 2, 1e-15);
    EXPECT_NEAR(distance(*knot.out, knot.at), 4, 1e-15);
}

TEST(HandleAlignment, leavesOtherJoinsAlone) {
    const SplineCurve smooth = heldCurve(Join::smooth, {3, 5}, {6, 5});
    EXPECT_EQ(withHandlesAligned(smooth, allKnots(smooth)), smooth);
}

RC_GTEST_PROP(HandleEqualization, makesBothEquallyLongAndKeepsDirections, ()) {
    const SplineCurve curve = anySpline();
    const std::vector<KnotHandles> before = knotHandles(curve);
    const std::vector<int> all = allKnots(curve);
    const SplineCurve equalized = withHandlesEqualized(curve, all);
    const std::vector<KnotHandles> after = knotHandles(equalized);
    for (std::size_t i = 0; i < after.size(); ++i) {
        const SplineKnot& knot = equalized.knots[i];
        if (!after[i].in || !after[i].out || curve.knots[i].join == Join::symmetric)
            continue;
        const Vector in = *after[i].in - knot.at;
        const Vector out = *after[i].out - knot.at;
        RC_ASSERT(std::abs(length(in) - length(out)) <= 1e-12 * (1 + length(in)));
        const Vector old = *before[i].in - knot.at;
        if (curve.knots[i].join == Join::corner && old != Vector{})
            RC_ASSERT(dot(old, in) >= length(old) * length(in) * (1 - 1e-9));
    }
}

TEST(HandleEqualization, takesTheMeanAndBringsRetractedOnesOut) {
    EXPECT_EQ(withHandlesEqualized(heldCurve(Join::smooth, {3, 5}, {6, 5}), kMiddle).knots[1],
              heldKnot({5, 5}, Join::smooth, Point{3.5, 5}, Point{6.5, 5}));
    EXPECT_EQ(withHandlesEqualized(heldCurve(Join::corner, {5, 5}, {5, 9}), kMiddle).knots[1],
              heldKnot({5, 5}, Join::corner, Point{5, 3}, Point{5, 7}));
    const SplineCurve retracted = heldCurve(Join::corner, {5, 5}, {5, 5});
    EXPECT_EQ(withHandlesEqualized(retracted, kMiddle), retracted);
}

TEST(HandleEqualization, makesAutomaticKnotsSymmetric) {
    const SplineCurve curve = curveThrough(Rule::catmullRom, {{0, 0}, {5, 5}, {7, 0}});
    EXPECT_EQ(withHandlesEqualized(curve, kMiddle).knots[1].join, Join::symmetric);
}

TEST(PullingHandlesOut, putsRetractedOnesWhereTheRuleWould) {
    const SplineCurve plain = curveThrough(Rule::mirror, {{0, 0}, {5, 5}, {10, 0}});
    const KnotHandles placed = knotHandles(plain)[1];
    for (const Join join : {Join::corner, Join::smooth, Join::symmetric}) {
        const SplineKnot knot = withHandlesPulledOut(heldCurve(join, {5, 5}, {5, 5}), kMiddle).knots[1];
        EXPECT_EQ(knot.join, join);
        EXPECT_NEAR(distance(*knot.in, *placed.in), 0, 1e-14);
        EXPECT_NEAR(distance(*knot.out, *placed.out), 0, 1e-14);
    }
}

TEST(PullingHandlesOut, keepsASmoothKnotInLineAndHandlesThatAreOut) {
    const SplineKnot knot = withHandlesPulledOut(heldCurve(Join::smooth, {5, 5}, {5, 8}), kMiddle).knots[1];
    EXPECT_EQ(knot.out, (Point{5, 8}));
    EXPECT_EQ(knot.in->x, 5);
    EXPECT_LT(knot.in->y, 5);
    const SplineCurve out = heldCurve(Join::corner, {3, 5}, {6, 5});
    EXPECT_EQ(withHandlesPulledOut(out, allKnots(out)), out);
}

TEST(PullingHandlesOut, keepsTheMirrorOfASymmetricKnotUnderARuleThatHasNone) {
    SplineCurve curve = curveThrough(Rule::catmullRom, {{0, 0}, {5, 5}, {7, 0}});
    curve.knots[1] = heldKnot({5, 5}, Join::symmetric, Point{5, 5}, Point{5, 5});
    const SplineKnot knot = withHandlesPulledOut(curve, kMiddle).knots[1];
    EXPECT_NE(knot.in, knot.at);
    EXPECT_NEAR(distance(mirrored(*knot.in, knot.at), *knot.out), 0, 1e-14);
}

RC_GTEST_PROP(RetractingHandles, putsThemOnTheirKnotsAndPullsThemOutAgain, ()) {
    SplineCurve curve = anySpline();
    curve.degree = std::max(curve.degree, 3);
    curve.inner.clear();
    const std::vector<int> all = allKnots(curve);
    const SplineCurve retracted = withHandlesRetracted(curve, all);
    const std::vector<KnotHandles> handles = knotHandles(retracted);
    for (std::size_t i = 0; i < handles.size(); ++i) {
        RC_ASSERT(retracted.knots[i].join == Join::corner);
        RC_ASSERT(!handles[i].in || *handles[i].in == curve.knots[i].at);
        RC_ASSERT(!handles[i].out || *handles[i].out == curve.knots[i].at);
    }
    RC_ASSERT(withHandlesRetracted(retracted, all) == retracted);
    SplineCurve plain = retracted;
    for (SplineKnot& knot : plain.knots)
        knot.join = Join::automatic;
    const std::vector<KnotHandles> placed = knotHandles(plain);
    const std::vector<KnotHandles> pulled = knotHandles(withHandlesPulledOut(retracted, all));
    for (std::size_t i = 0; i < handles.size(); ++i)
        RC_ASSERT(pulled[i].out == placed[i].out);
}

TEST(HandleEdits, leaveParabolasAlone) {
    const SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {5, 5}, {10, 0}}, false, 2);
    for (auto* edit : {withHandlesAligned, withHandlesEqualized, withHandlesPulledOut, withHandlesRetracted})
        EXPECT_EQ(edit(curve, kMiddle), curve);
}

} // namespace
} // namespace kriva
