#include "core/sheets/spline/editing/joins.h"
#include "core/sheets/spline/spline.h"
#include "tests/core/sheets/spline/spline_values.h"

#include <numbers>

namespace kriva {
namespace {

using test::anyPoint;
using test::anySpline;
using test::curveThrough;
using test::heldKnot;
using Angle = HandleWay::Angle;
using Join = SplineKnot::Join;
using Rule = SplineCurve::Rule;

constexpr GripId kOut{GripKind::outHandle, 1};

/// Three knots with handles of 2 and 1 at the middle one, (5, 5).
SplineCurve heldCurve(Join join) {
    SplineCurve curve = curveThrough(Rule::natural, {{0, 0}, {5, 5}, {10, 0}});
    curve.knots[1] = heldKnot({5, 5}, join, Point{3, 5}, Point{6, 5});
    return curve;
}

TEST(HandleDrag, withoutModifiersIsThatOfTheGrip) {
    for (const Join join : {Join::automatic, Join::symmetric, Join::smooth, Join::corner}) {
        const SplineCurve curve = heldCurve(join);
        EXPECT_EQ(withHandleDragged(curve, kOut, {{1, 2}}), withGripsMoved(curve, std::span(&kOut, 1), {1, 2}));
    }
}

RC_GTEST_PROP(HandleDrag, stepsToMultiplesOf15Degrees, ()) {
    const SplineCurve curve = heldCurve(Join::corner);
    const Vector by = *anyPoint() - Point{};
    const SplineCurve dragged = withHandleDragged(curve, kOut, {by, Angle::stepped});
    const Vector wanted = Point{6, 5} + by - Point{5, 5};
    const Vector handle = *dragged.knots[1].out - Point{5, 5};
    if (wanted == Vector{})
        RC_DISCARD();
    const double steps = std::atan2(handle.y, handle.x) / (std::numbers::pi / 12);
    RC_ASSERT(std::abs(steps - std::round(steps)) <= 1e-9);
    RC_ASSERT(std::abs(dot(handle, handle - wanted)) <= 1e-9 * dot(wanted, wanted)); // the nearest place of its ray
    RC_ASSERT(std::abs(cross(handle, wanted)) <=
              length(handle) * length(wanted) * std::sin(std::numbers::pi / 24) * (1 + 1e-9));
}

TEST(HandleDrag, stepsMeetAxesAndDiagonals) {
    const SplineCurve curve = heldCurve(Join::corner);
    EXPECT_EQ(withHandleDragged(curve, kOut, {{-1.25, 4}, Angle::stepped}).knots[1].out, (Point{5, 9}));
    const Vector diagonal = *withHandleDragged(curve, kOut, {{1, -2.25}, Angle::stepped}).knots[1].out - Point{5, 5};
    EXPECT_DOUBLE_EQ(diagonal.x, -diagonal.y);
}

TEST(HandleDrag, keepsTheAngleOfTheBeginningAndStopsOnTheKnot) {
    const SplineCurve curve = heldCurve(Join::corner);
    EXPECT_EQ(withHandleDragged(curve, kOut, {{2, 7}, Angle::kept}).knots[1].out, (Point{8, 5}));
    EXPECT_EQ(withHandleDragged(curve, kOut, {{-9, 7}, Angle::kept}).knots[1].out, (Point{5, 5}));
}

TEST(HandleDrag, keepsNoAngleOfARetractedHandle) {
    SplineCurve curve = heldCurve(Join::corner);
    curve.knots[1].out = curve.knots[1].at;
    EXPECT_EQ(withHandleDragged(curve, kOut, {{2, 7}, Angle::kept}).knots[1].out, (Point{7, 12}));
}

TEST(HandleDrag, leavesTheOtherHandleBehindAtACorner) {
    const SplineKnot knot =
        withHandleDragged(heldCurve(Join::symmetric), kOut, {{0, 3}, Angle::free, {}, Vector{-2, 0}}).knots[1];
    EXPECT_EQ(knot, heldKnot({5, 5}, Join::corner, Point{3, 5}, Point{6, 8}));
}

TEST(HandleDrag, carriesTheKnotWithBothHandles) {
    const SplineCurve dragged = withHandleDragged(heldCurve(Join::corner), kOut, {{3, 4}, Angle::free, {1, 4}});
    EXPECT_EQ(dragged.knots[1], heldKnot({6, 9}, Join::corner, Point{4, 9}, Point{9, 9}));
}

TEST(HandleDrag, takesTheArrowsOfEndDerivatives) {
    SplineCurve curve = curveThrough(Rule::clamped, {{0, 0}, {5, 5}, {10, 0}});
    curve.startDerivative = Vector{2, 0};
    const GripId start{GripKind::startDerivative};
    EXPECT_EQ(withHandleDragged(curve, start, {{1, 4}, Angle::kept}).startDerivative, (Vector{3, 0}));
    const SplineCurve carried = withHandleDragged(curve, start, {{1, 4}, Angle::free, {1, 4}});
    EXPECT_EQ(carried.startDerivative, curve.startDerivative);
    EXPECT_EQ(carried.knots[0].at, (Point{1, 4}));
    EXPECT_EQ(withHandleRetracted(curve, start)->startDerivative, std::nullopt);
}

RC_GTEST_PROP(HandleDrag, ofAGripThatDoesNotExistChangesNothing, ()) {
    const SplineCurve curve = anySpline();
    const int count = static_cast<int>(curve.knots.size());
    RC_ASSERT(withHandleDragged(curve, {GripKind::outHandle, count}, {{1, 1}}) == curve);
    RC_ASSERT(withHandleDragged(curve, {GripKind::point, 0}, {{1, 1}}) == curve);
}

TEST(HandleRetraction, leavesTheOtherHandleAtACorner) {
    const SplineCurve retracted = *withHandleRetracted(heldCurve(Join::symmetric), kOut);
    EXPECT_EQ(retracted.knots[1], heldKnot({5, 5}, Join::corner, Point{3, 5}, Point{5, 5}));
    EXPECT_EQ(withHandleRetracted(retracted, {GripKind::point, 1}), std::nullopt);
    EXPECT_EQ(withHandleRetracted(retracted, {GripKind::inHandle, 0}), std::nullopt) << "an open end has none";
}

TEST(PullOfANewKnot, startsWithRetractedHandles) {
    const SplineCurve ready = *readyToPull(curveThrough(Rule::mirror, {{0, 0}, {4, 0}}), 1);
    EXPECT_EQ(ready.knots[1], heldKnot({4, 0}, Join::symmetric, Point{4, 0}, Point{4, 0}));
    const SplineCurve pulled = withHandleDragged(ready, {GripKind::outHandle, 1}, {{1, 2}});
    EXPECT_EQ(pulled.knots[1], heldKnot({4, 0}, Join::symmetric, Point{3, -2}, Point{5, 2}));
    EXPECT_EQ(readyToPull(curveThrough(Rule::mirror, {{0, 0}, {4, 0}}, false, 2), 1), std::nullopt);
}

TEST(ClosingClick, needsTheFirstOfThreeKnotsOfAnOpenChain) {
    const SplineCurve open = curveThrough(Rule::mirror, {{0, 0}, {4, 0}, {2, 3}});
    EXPECT_TRUE(closedAt(open, 0)->closed);
    EXPECT_EQ(closedAt(open, 1), std::nullopt);
    EXPECT_EQ(closedAt(*closedAt(open, 0), 0), std::nullopt);
    EXPECT_EQ(closedAt(curveThrough(Rule::mirror, {{0, 0}, {4, 0}}), 0), std::nullopt);
}

} // namespace
} // namespace kriva
