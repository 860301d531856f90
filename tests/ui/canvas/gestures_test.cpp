#include "tests/ui/canvas/canvas_fixture.h"

#include <QContextMenuEvent>

namespace kriva::ui {
namespace {

class Gesture : public CanvasTest {};

constexpr Qt::KeyboardModifiers kShiftCtrl = Qt::ShiftModifier | Qt::ControlModifier;

TEST_F(Gesture, aClickTellsWhatItHits) {
    click({0, 100});
    click({0, 50});
    click({0, -100});
    EXPECT_EQ(calls(), list({"click 0,100 on 1:1", "click 0,50 on 1", "click 0,-100"}));
}

TEST_F(Gesture, aClickTellsTheMarkThatItHits) {
    CanvasCurve curve = parabola();
    curve.figure.layers.push_back({"construction", {}, {{{{0, -40}, {50, 37}}, Role::construction}}});
    view.scene().setCurves({curve});
    click({3, -42});
    click({50, 37});
    EXPECT_EQ(calls(), list({"click 3,-42 on mark 0,-40", "click 50,37 on 1 on mark 50,37"}));
    drag({0, -40}, {40, -80});
    EXPECT_EQ(calls(), list({"select"})) << "a rubber band around nothing";
}

TEST_F(Gesture, aDoubleClickIsToldWithItsSecondPress) {
    click({0, 50});
    pressAgain({0, 50});
    release({0, 50});
    EXPECT_EQ(calls(), list({"click 0,50 on 1", "double click 0,50 on 1"}));
}

TEST_F(Gesture, theSecondPressOfADoubleClickThatMeansNothingIsOneMoreClick) {
    click({0, 100});
    pressAgain({0, 100});
    release({0, 100});
    EXPECT_EQ(calls(), list({"click 0,100 on 1:1", "click 0,100 on 1:1"}));
    QTest::keyPress(&view, Qt::Key_Space);
    pressAgain({0, 50});
    move({10, 50});
    release({10, 50});
    QTest::keyRelease(&view, Qt::Key_Space);
    EXPECT_EQ(calls(), QStringList()) << "it pans";
}

TEST_F(Gesture, lessThanFourPixelsOfMovementAreAClick) {
    press({0, 100});
    move({2, 102});
    release({2, 102});
    EXPECT_EQ(calls(), list({"click 0,100 on 1:1"}));
    press({0, 100});
    move({4, 100});
    move({0, 100});
    release({0, 100});
    EXPECT_EQ(calls(), list({"begin 0,100 on 1:1", "drag 4,0", "drag 0,0", "end"}));
}

TEST_F(Gesture, aDragTellsTheWholeWaySinceThePressOncePerMove) {
    press({1, 101});
    move({11, 111});
    move({21, 81});
    release({21, 81});
    EXPECT_EQ(calls(), list({"begin 1,101 on 1:1", "drag 10,10", "drag 20,-20", "end"}));
}

TEST_F(Gesture, aModifierPressedDuringADragTakesEffectAtOnce) {
    press({0, 100});
    move({30, 110});
    holdModifier(Qt::Key_Control);
    EXPECT_EQ(input.dragKeys.modifiers, Qt::ControlModifier);
    letGoModifier(Qt::Key_Control, Qt::ControlModifier);
    release({30, 110});
    EXPECT_EQ(input.dragKeys.modifiers, Qt::NoModifier);
    EXPECT_EQ(calls().mid(1), list({"drag 30,10", "drag 30,10", "drag 30,10", "end"}));
}

TEST_F(Gesture, spaceDuringADragIsToldAtOnceAndPansNothing) {
    press({-100, -60});
    move({-100, -40});
    QTest::keyPress(&view, Qt::Key_Space);
    EXPECT_TRUE(input.dragKeys.isSpaceHeld);
    move({-90, -40});
    QTest::keyRelease(&view, Qt::Key_Space);
    EXPECT_FALSE(input.dragKeys.isSpaceHeld);
    release({-90, -40});
    EXPECT_EQ(calls().mid(1), list({"drag 0,20", "drag 0,20", "drag 10,20", "drag 10,20", "end"}));
    EXPECT_EQ(view.mapping().centre, (Point{0, 0}));
}

TEST_F(Gesture, theGhostIsThereUntilThePointerLeavesOrDrags) {
    const auto leave = [this] {
        QEvent event(QEvent::Leave);
        QApplication::sendEvent(view.viewport(), &event);
    };
    view.scene().setGhost(Point{0, 50});
    leave();
    EXPECT_EQ(view.scene().ghost(), std::nullopt);
    view.scene().setGhost(Point{0, 50});
    drag({0, 50}, {0, 60});
    EXPECT_EQ(view.scene().ghost(), std::nullopt);
}

TEST_F(Gesture, escAndTheRightButtonTakeADragBack) {
    press({0, 100});
    move({0, 120});
    key(Qt::Key_Escape);
    move({0, 140});
    release({0, 140});
    EXPECT_EQ(calls(), list({"begin 0,100 on 1:1", "drag 0,20", "cancel"}));

    press({0, 100});
    move({0, 120});
    press({0, 120}, {}, Qt::RightButton);
    release({0, 120}, {}, Qt::RightButton);
    release({0, 120});
    EXPECT_EQ(calls(), list({"begin 0,100 on 1:1", "drag 0,20", "cancel"})) << "and asks for no menu";
}

TEST_F(Gesture, aDragEndsWhenTheCanvasLosesTheMouse) {
    const auto startDrag = [this] {
        press({0, 100});
        move({0, 120});
        calls();
    };
    startDrag();
    view.clearFocus();
    EXPECT_EQ(calls(), list({"end"}));
    buttons = {};

    view.setFocus();
    startDrag();
    buttons = {}; // the release went to another window
    move({0, 130});
    EXPECT_EQ(calls(), list({"end"}));

    startDrag();
    view.hide();
    EXPECT_EQ(calls(), list({"end"}));
}

TEST_F(Gesture, theRubberBandSelectsAddsAndSubtracts) {
    drag({-120, -20}, {20, 120});
    EXPECT_EQ(calls(), list({"select 1:0 1:1"})) << "and no handle";
    drag({90, -10}, {120, 10}, Qt::ShiftModifier);
    EXPECT_EQ(calls(), list({"select 1:0 1:1 1:2"}));
    drag({-20, 80}, {20, 120}, kShiftCtrl);
    EXPECT_EQ(calls(), list({"select 1:0 1:2"}));
    drag({80, -20}, {120, 20}, Qt::AltModifier);
    EXPECT_EQ(calls(), list({"select 1:0"}));
    drag({-50, -100}, {50, -50});
    EXPECT_EQ(calls(), list({"select"}));
}

TEST_F(Gesture, escTakesTheRubberBandBack) {
    press({-120, -120});
    move({120, 120});
    key(Qt::Key_Escape);
    release({120, 120});
    EXPECT_EQ(calls(), QStringList());
}

TEST_F(Gesture, theMiddleButtonAndSpacePan) {
    press({0, 0}, {}, Qt::MiddleButton);
    move({30, 10}); // places count in the view that moves along
    release({0, 0}, {}, Qt::MiddleButton);
    EXPECT_EQ(view.mapping().centre, (Point{-30, -10}));
    QTest::keyPress(&view, Qt::Key_Space);
    press({0, 0});
    move({-30, -10});
    release({0, 0});
    QTest::keyRelease(&view, Qt::Key_Space);
    EXPECT_EQ(view.mapping().centre, (Point{0, 0}));
    EXPECT_EQ(calls(), QStringList());
    click({0, 100});
    EXPECT_EQ(calls(), list({"click 0,100 on 1:1"})) << "Space is up again";
}

TEST_F(Gesture, theWheelScrollsAndZoomsAtThePointer) {
    turnWheel({0, 0}, {0, 120});
    EXPECT_EQ(view.mapping().centre, (Point{0, 60}));
    turnWheel({0, 0}, {0, -120}, Qt::ShiftModifier);
    EXPECT_EQ(view.mapping().centre, (Point{60, 60}));
    const QPointF before = view.mapping().toPixels({100, 0});
    turnWheel({100, 0}, {0, 240}, Qt::ControlModifier);
    EXPECT_DOUBLE_EQ(view.mapping().scale, kZoomStep * kZoomStep);
    EXPECT_LT((view.mapping().toPixels({100, 0}) - before).manhattanLength(), 1e-9);
}

TEST_F(Gesture, aDragGoesOnWhileTheViewMovesUnderThePointer) {
    press({0, 100});
    move({0, 120});
    turnWheel({0, 120}, {0, 120});
    release({0, 180});
    EXPECT_EQ(calls().mid(1), list({"drag 0,20", "drag 0,80", "end"}));
}

TEST_F(Gesture, theRightButtonClicksUnlessItWasDragged) {
    press({0, 100}, {}, Qt::RightButton);
    EXPECT_EQ(calls(), QStringList());
    release({0, 100}, {}, Qt::RightButton);
    EXPECT_EQ(calls(), list({"right click 0,100 on 1:1"}));
    press({0, 100}, {}, Qt::RightButton);
    move({50, 100});
    release({50, 100}, {}, Qt::RightButton);
    EXPECT_EQ(calls(), QStringList());
}

TEST_F(Gesture, theMenuKeyIsARightClickOnTheSelectedPointOrInTheMiddle) {
    QContextMenuEvent event(QContextMenuEvent::Keyboard, QPoint(1, 1), view.mapToGlobal(QPoint(1, 1)));
    QApplication::sendEvent(&view, &event);
    view.scene().setSelection({point(2)});
    QApplication::sendEvent(&view, &event);
    EXPECT_EQ(calls(), list({"right click 0,0", "right click 100,0 on 1:2"}));
}

TEST_F(Gesture, hoveringTellsWhatIsUnderThePointerAndWhichKeysAreHeld) {
    move({0, 101});
    EXPECT_EQ(input.hovered, (Hit{point(1), {}}));
    move({0, 50});
    EXPECT_EQ(input.hovered, (Hit{{}, 1}));
    holdModifier(Qt::Key_Alt);
    EXPECT_EQ(input.hoverModifiers, Qt::AltModifier);
    letGoModifier(Qt::Key_Alt, Qt::AltModifier);
    EXPECT_EQ(input.hoverModifiers, Qt::NoModifier);
}

} // namespace
} // namespace kriva::ui
