#include "core/sheets/spline/editing/joins.h"
#include "tests/support/canvas_hand.h"

namespace kriva::ui {
namespace {

using test::GestureTest;
using test::isNear;
using test::kCtrlAlt;
using Join = SplineKnot::Join;

/// The knot (2, 4) has the handles (1, 3) and (4, 6).
class HandleGesture : public GestureTest, public testing::Test {
  protected:
    HandleGesture()
        : GestureTest(test::kSpline) {
        use(held(Join::smooth));
    }
    [[nodiscard]] SplineCurve held(Join join) {
        auto curve = std::get<SplineCurve>(arc(2));
        curve.knots[1] = {{2, 4}, join, Point{1, 3}, Point{4, 6}};
        return curve;
    }
    static constexpr Point kOut{4, 6};
};

TEST_F(HandleGesture, aDragKeepsThePromiseOfTheJoin) {
    drag(kOut, {4, 4});
    EXPECT_EQ(knot(1).join, Join::smooth);
    EXPECT_TRUE(isNear(*knot(1).out, {4, 4}));
    EXPECT_TRUE(isNear(*knot(1).in, {2 - std::sqrt(2.0), 4}));
    expectOneStep("Move a handle of knot 1");
}

TEST_F(HandleGesture, anAutomaticKnotBecomesSymmetricUnlessTheHandleComesHome) {
    use(arc(2));
    const Point out = *knotHandles(spline())[1].out;
    press(out);
    move(out + Vector{1, 0});
    EXPECT_EQ(knot(1).join, Join::symmetric);
    move(out);
    release(out);
    expectNoStep();
    drag(out, out + Vector{1, 0});
    EXPECT_TRUE(isNear(mirrored(*knot(1).out, knot(1).at), *knot(1).in));
    expectOneStep("Move a handle of knot 1");
}

TEST_F(HandleGesture, ctrlStepsTheAngleBy15DegreesAtOnce) {
    press(kOut);
    move({4, 4.2});
    hold(Qt::Key_Control);
    EXPECT_TRUE(isNear(*knot(1).out, {4, 4}));
    letGo(Qt::Key_Control, Qt::ControlModifier);
    EXPECT_TRUE(isNear(*knot(1).out, {4, 4.2}));
    hold(Qt::Key_Control);
    move({2.1, 7}, Qt::ControlModifier);
    release({2.1, 7}, Qt::ControlModifier);
    EXPECT_TRUE(isNear(*knot(1).out, {2, 7}));
    expectOneStep("Move a handle of knot 1");
}

TEST_F(HandleGesture, ctrlAltKeepsTheAngleAndTheTie) {
    press(kOut);
    move({5, 5});
    hold(Qt::Key_Control);
    hold(Qt::Key_Alt, Qt::ControlModifier);
    EXPECT_TRUE(isNear(*knot(1).out, {4, 6}));
    move({5, 7.5}, kCtrlAlt);
    EXPECT_TRUE(isNear(*knot(1).out, {5.25, 7.25}));
    EXPECT_TRUE(isNear(*knot(1).in, {1, 3}));
    release({5, 7.5}, kCtrlAlt);
    EXPECT_EQ(knot(1).join, Join::smooth);
    expectOneStep("Move a handle of knot 1");
}

TEST_F(HandleGesture, altLeavesTheOtherHandleWhereItIsWhileHeld) {
    use(held(Join::symmetric));
    press(kOut);
    move({4, 4});
    EXPECT_TRUE(isNear(*knot(1).in, {0, 4}));
    hold(Qt::Key_Alt);
    move({3, 6}, Qt::AltModifier);
    EXPECT_EQ(knot(1).join, Join::corner);
    EXPECT_TRUE(isNear(*knot(1).in, {0, 4}));
    letGo(Qt::Key_Alt, Qt::AltModifier);
    EXPECT_EQ(knot(1).join, Join::symmetric);
    EXPECT_TRUE(isNear(*knot(1).in, {1, 2}));
    hold(Qt::Key_Alt);
    move({4, 6.5}, Qt::AltModifier);
    release({4, 6.5}, Qt::AltModifier);
    EXPECT_EQ(knot(1).join, Join::corner);
    EXPECT_TRUE(isNear(*knot(1).in, {1, 2}));
    EXPECT_TRUE(isNear(*knot(1).out, {4, 6.5}));
    expectOneStep("Move a handle of knot 1");
}

TEST_F(HandleGesture, spaceCarriesTheKnotAlongWhileHeld) {
    press(kOut);
    move({4, 7});
    const Vector in = *knot(1).in - knot(1).at;
    hold(Qt::Key_Space);
    move({5, 7.5});
    EXPECT_TRUE(isNear(knot(1).at, {3, 4.5}));
    EXPECT_TRUE(isNear(*knot(1).out, {5, 7.5}));
    EXPECT_TRUE(isNear(knot(1).at + in, *knot(1).in));
    letGo(Qt::Key_Space);
    move({6, 7.5});
    EXPECT_TRUE(isNear(knot(1).at, {3, 4.5}));
    EXPECT_TRUE(isNear(*knot(1).out, {6, 7.5}));
    hold(Qt::Key_Space);
    move({6, 8});
    release({6, 8});
    letGo(Qt::Key_Space);
    EXPECT_TRUE(isNear(knot(1).at, {3, 5}));
    EXPECT_TRUE(isNear(*knot(1).out, {6, 8}));
    EXPECT_EQ(canvas.mapping().centre, (Point{4, 2})) << "nothing was panned";
    expectOneStep("Move a handle of knot 1");
}

TEST_F(HandleGesture, spaceBeforeThePressPans) {
    hold(Qt::Key_Space);
    drag(kOut, {4, 7});
    letGo(Qt::Key_Space);
    EXPECT_NE(canvas.mapping().centre, (Point{4, 2}));
    expectNoStep();
}

TEST_F(HandleGesture, escTakesBackWhatKeysDid) {
    press(kOut);
    move({4, 7});
    hold(Qt::Key_Space);
    move({5, 8});
    key(Qt::Key_Escape);
    letGo(Qt::Key_Space);
    release({5, 8});
    expectNoStep();
    drag(kOut, {4, 5});
    EXPECT_TRUE(isNear(*knot(1).out, {4, 5}));
    EXPECT_TRUE(isNear(knot(1).at, {2, 4})) << "the next drag starts anew";
}

TEST_F(HandleGesture, ctrlClickRetractsIt) {
    click(kOut, Qt::ControlModifier);
    EXPECT_EQ(knot(1), (SplineKnot{{2, 4}, Join::corner, Point{1, 3}, Point{2, 4}}));
    expectOneStep("Retract a handle of knot 1");
    click({2, 4}, Qt::ControlModifier);
    EXPECT_EQ(steps().size(), 1) << "a knot is only selected";
}

TEST_F(HandleGesture, arrowsOfEndDerivativesStepKeepAndGiveWay) {
    auto clamped = std::get<SplineCurve>(arc(2));
    clamped.rule = SplineCurve::Rule::clamped;
    clamped.startDerivative = Vector{-3, 0};
    clamped.endDerivative = Vector{3, 0};
    use(clamped);
    drag({-3, 0}, {-2, 0.1}, Qt::ControlModifier);
    EXPECT_TRUE(isNear(Point{} + *spline().startDerivative, {-2, 0}));
    expectOneStep("Change the start derivative");
    click({-2, 0}, Qt::ControlModifier);
    EXPECT_EQ(spline().startDerivative, std::nullopt);
    EXPECT_EQ(steps().size(), 2);
}

TEST_F(HandleGesture, whatIsHiddenIsNotHit) {
    document().setLayerShown(sheet, "handles", false);
    drag(kOut, {4, 4});
    EXPECT_EQ(curve(), before);
    document().setLayerShown(sheet, "handles", true);
    document().setLayerShown(sheet, "knots", false);
    click({2, 4});
    EXPECT_TRUE(tab.editor().selectedPoints().empty());
    drag(kOut, {4, 4});
    EXPECT_TRUE(isNear(*knot(1).out, {4, 4}));
}

TEST_F(HandleGesture, hintsFollowTheKeysHeld) {
    move(kOut);
    EXPECT_EQ(hint(), QStringLiteral("Drag: move the handle, Ctrl: in steps of 15°   Ctrl+click: retract it"));
    hold(Qt::Key_Control);
    EXPECT_EQ(hint(), QStringLiteral("Ctrl+drag: steps of 15°   Ctrl+click: retract the handle"));
    letGo(Qt::Key_Control, Qt::ControlModifier);
    press(kOut);
    move({4, 7});
    EXPECT_TRUE(hint().contains(QStringLiteral("Space: carry the knot")));
    hold(Qt::Key_Space);
    EXPECT_EQ(hint(), QStringLiteral("Space: the knot goes along"));
    letGo(Qt::Key_Space);
    hold(Qt::Key_Alt);
    EXPECT_EQ(hint(), QStringLiteral("Alt: the other handle stays"));
    hold(Qt::Key_Control, Qt::AltModifier);
    EXPECT_EQ(hint(), QStringLiteral("Ctrl+Alt: the handle keeps its angle"));
    release({4, 7});
}

} // namespace
} // namespace kriva::ui
