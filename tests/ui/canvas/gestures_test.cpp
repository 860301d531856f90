#include "tests/ui/canvas/canvas_fixture.h"

#include <QSignalSpy>

namespace kriva::ui {
namespace {

class Gesture : public CanvasTest {};

constexpr Qt::KeyboardModifiers kShiftCtrl = Qt::ShiftModifier | Qt::ControlModifier;
constexpr Qt::KeyboardModifiers kCtrlAlt = Qt::ControlModifier | Qt::AltModifier;

TEST_F(Gesture, aClickSelectsWhatItHits) {
    click({0, 100});
    EXPECT_EQ(wishes(), list({"select 1:1"}));
    click({0, 50});
    EXPECT_EQ(wishes(), list({"activate 1"}));
    click({0, -100});
    EXPECT_EQ(wishes(), list({"select"}));
    click({0, -100});
    EXPECT_EQ(wishes(), QStringList()) << "nothing was selected";
}

TEST_F(Gesture, aClickOnAMarkAsksForAnExplanation) {
    CanvasCurve curve = parabola();
    curve.figure.layers.push_back({"construction", {}, {{{{0, -40}, {50, 37}}, Role::construction}}});
    view.setCurves({curve});
    click({3, -42});
    EXPECT_EQ(wishes(), list({"explain 0,-40"}));
    click({50, 37});
    EXPECT_EQ(wishes(), list({"activate 1", "explain 50,37"})) << "the mark lies on the curve";
    drag({0, -40}, {40, -80});
    EXPECT_EQ(wishes(), list({"select"})) << "a rubber band around nothing";
}

TEST_F(Gesture, shiftAndAClickToggle) {
    click({0, 100});
    click({100, 0}, Qt::ShiftModifier);
    click({0, 100}, Qt::ShiftModifier);
    click({0, -100}, Qt::ShiftModifier);
    EXPECT_EQ(wishes(), list({"select 1:1", "select 1:1 1:2", "select 1:2"}));
}

TEST_F(Gesture, altAndAClickAddOffPointsAndRemoveThem) {
    click({-150, -20}, Qt::AltModifier);
    click({0, 50}, Qt::AltModifier);
    click({0, 100}, Qt::AltModifier);
    EXPECT_EQ(wishes(), list({"add -150,-20", "add 0,50", "remove 1:1"}));
}

TEST_F(Gesture, ctrlAltAndAClickInsertIntoACurve) {
    click({0, 50}, kCtrlAlt);
    click({0, -100}, kCtrlAlt);
    EXPECT_EQ(wishes(), list({"insert into 1 0,50"}));
}

TEST_F(Gesture, aDoubleClickAddsOnEmptyCanvasAndInsertsIntoACurve) {
    for (const Point at : {Point{0, -100}, Point{0, 50}, Point{0, 100}}) {
        click(at);
        pressAgain(at);
        release(at);
    }
    EXPECT_EQ(wishes(), list({"add 0,-100", "activate 1", "insert into 1 0,50", "select 1:1", "select 1:1"}));
}

TEST_F(Gesture, theSecondPressOfADoubleClickIsOneMoreClickWithAlt) {
    click({50, -100}, Qt::AltModifier);
    pressAgain({55, -100}, Qt::AltModifier);
    release({55, -100}, Qt::AltModifier);
    EXPECT_EQ(wishes(), list({"add 50,-100", "add 55,-100"}));
}

TEST_F(Gesture, theAddToolAddsInsertsAndMeetsPoints) {
    view.setTool(Tool::add);
    click({20, -50});
    pressAgain({21, -50});
    release({21, -50});
    click({0, 50});
    click({-100, 0});
    EXPECT_EQ(wishes(), list({"add 20,-50", "add 21,-50", "insert into 1 0,50", "add on 1:0 -100,0"}));
}

TEST_F(Gesture, lessThanFourPixelsOfMovementAreAClick) {
    press({0, 100});
    move({2, 102});
    release({2, 102});
    EXPECT_EQ(wishes(), list({"select 1:1"}));
    press({0, 100});
    move({4, 100});
    move({0, 100});
    release({0, 100});
    EXPECT_EQ(wishes(), list({"begin 1:1", "drag 4,0", "drag 0,0", "end"}));
}

TEST_F(Gesture, aDragTellsTheWholeWaySinceThePressOncePerMove) {
    press({1, 101});
    move({11, 111});
    move({21, 81});
    release({21, 81});
    EXPECT_EQ(wishes(), list({"select 1:1", "begin 1:1", "drag 10,10", "drag 20,-20", "end"}));
}

TEST_F(Gesture, draggingASelectedPointKeepsTheSelection) {
    view.setSelection({point(0), point(1)});
    drag({0, 100}, {0, 120});
    EXPECT_EQ(wishes(), list({"begin 1:1", "drag 0,20", "end"}));
}

TEST_F(Gesture, ctrlLocksPointsToAnAxisAndLeavesHandlesFree) {
    drag({0, 100}, {30, 110}, Qt::ControlModifier);
    drag({-100, -60}, {-70, -50}, Qt::ControlModifier);
    EXPECT_EQ(wishes(),
              list({"select 1:1", "begin 1:1", "drag 30,0", "end", "select 1h:0", "begin 1h:0", "drag 30,10", "end"}));
}

TEST_F(Gesture, aModifierPressedDuringADragTakesEffectAtOnce) {
    press({0, 100});
    move({30, 110});
    holdModifier(Qt::Key_Control);
    letGoModifier(Qt::Key_Control, Qt::ControlModifier);
    release({30, 110});
    EXPECT_EQ(wishes().mid(2), list({"drag 30,10", "drag 30,0", "drag 30,10", "end"}));
}

TEST_F(Gesture, spaceDuringADragIsToldAtOnceAndPansNothing) {
    press({-100, -60});
    move({-100, -40});
    QTest::keyPress(&view, Qt::Key_Space);
    EXPECT_TRUE(client.dragKeys.isSpaceHeld);
    move({-90, -40});
    QTest::keyRelease(&view, Qt::Key_Space);
    EXPECT_FALSE(client.dragKeys.isSpaceHeld);
    release({-90, -40});
    EXPECT_EQ(wishes().mid(2), list({"drag 0,20", "drag 0,20", "drag 10,20", "drag 10,20", "end"}));
    EXPECT_EQ(view.mapping().centre, (Point{0, 0}));
}

TEST_F(Gesture, ctrlAndAClickRetractAHandle) {
    click({-100, -60}, Qt::ControlModifier);
    click({0, 100}, Qt::ControlModifier);
    EXPECT_EQ(wishes(), list({"retract 1h:0", "select 1:1"}));
}

TEST_F(Gesture, theGhostIsThereUntilThePointerLeavesOrDrags) {
    const auto leave = [this] {
        QEvent event(QEvent::Leave);
        QApplication::sendEvent(view.viewport(), &event);
    };
    view.setGhost(Point{0, 50});
    leave();
    EXPECT_EQ(view.ghost(), std::nullopt);
    view.setGhost(Point{0, 50});
    drag({0, 50}, {0, 60});
    EXPECT_EQ(view.ghost(), std::nullopt);
}

TEST_F(Gesture, aDragOfTheCurveOrWithTheAddToolBeginsWhereItWasPressed) {
    drag({0, 50}, {0, 60});
    view.setTool(Tool::add);
    drag({50, -50}, {60, -50});
    drag({0, 50}, {0, 60});
    drag({0, 100}, {0, 110});
    EXPECT_EQ(wishes(),
              list({"begin curve 1 0,50", "drag 0,10", "end", "begin adding 50,-50", "drag 10,0", "end",
                    "begin inserting 1 0,50", "drag 0,10", "end", "select 1:1", "begin 1:1", "drag 0,10", "end"}));
}

TEST_F(Gesture, escAndTheRightButtonTakeADragBack) {
    press({0, 100});
    move({0, 120});
    key(Qt::Key_Escape);
    move({0, 140});
    release({0, 140});
    EXPECT_EQ(wishes().mid(1), list({"begin 1:1", "drag 0,20", "cancel"}));

    QSignalSpy menus(&view, &CanvasView::contextMenuRequested);
    press({0, 100});
    move({0, 120});
    press({0, 120}, {}, Qt::RightButton);
    release({0, 120}, {}, Qt::RightButton);
    release({0, 120});
    EXPECT_EQ(wishes(), list({"begin 1:1", "drag 0,20", "cancel"}));
    EXPECT_EQ(menus.size(), 0);
}

TEST_F(Gesture, aDragEndsWhenTheCanvasLosesTheMouse) {
    const auto startDrag = [this] {
        press({0, 100});
        move({0, 120});
        wishes();
    };
    startDrag();
    view.clearFocus();
    EXPECT_EQ(wishes(), list({"end"}));
    buttons = {};

    view.setFocus();
    startDrag();
    buttons = {}; // the release went to another window
    move({0, 130});
    EXPECT_EQ(wishes(), list({"end"}));

    startDrag();
    view.hide();
    EXPECT_EQ(wishes(), list({"end"}));
}

TEST_F(Gesture, theRubberBandSelectsAddsAndSubtracts) {
    drag({-120, -20}, {20, 120});
    EXPECT_EQ(wishes(), list({"select 1:0 1:1"})) << "and no handle";
    drag({90, -10}, {120, 10}, Qt::ShiftModifier);
    EXPECT_EQ(wishes(), list({"select 1:0 1:1 1:2"}));
    drag({-20, 80}, {20, 120}, kShiftCtrl);
    EXPECT_EQ(wishes(), list({"select 1:0 1:2"}));
    drag({80, -20}, {120, 20}, Qt::AltModifier);
    EXPECT_EQ(wishes(), list({"select 1:0"}));
    drag({-50, -100}, {50, -50});
    EXPECT_EQ(wishes(), list({"select"}));
}

TEST_F(Gesture, escTakesTheRubberBandBack) {
    press({-120, -120});
    move({120, 120});
    key(Qt::Key_Escape);
    release({120, 120});
    EXPECT_EQ(wishes(), QStringList());
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
    EXPECT_EQ(wishes(), QStringList());
    click({0, 100});
    EXPECT_EQ(wishes(), list({"select 1:1"})) << "Space is up again";
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
    EXPECT_EQ(wishes().mid(2), list({"drag 0,20", "drag 0,80", "end"}));
}

TEST_F(Gesture, theRightButtonAsksForAMenuUnlessItWasDragged) {
    QSignalSpy menus(&view, &CanvasView::contextMenuRequested);
    press({0, 100}, {}, Qt::RightButton);
    EXPECT_EQ(menus.size(), 0);
    release({0, 100}, {}, Qt::RightButton);
    ASSERT_EQ(menus.size(), 1);
    EXPECT_EQ(menus[0][1].value<Hit>().grip, point(1));
    press({0, 100}, {}, Qt::RightButton);
    move({50, 100});
    release({50, 100}, {}, Qt::RightButton);
    EXPECT_EQ(menus.size(), 1);
    EXPECT_EQ(wishes(), QStringList());
}

TEST_F(Gesture, hoveringTellsWhatIsUnderThePointerAndWhichKeysAreHeld) {
    move({0, 101});
    EXPECT_EQ(client.hovered, (Hit{point(1), {}}));
    move({0, 50});
    EXPECT_EQ(client.hovered, (Hit{{}, 1}));
    holdModifier(Qt::Key_Alt);
    EXPECT_EQ(client.hoverModifiers, Qt::AltModifier);
    letGoModifier(Qt::Key_Alt, Qt::AltModifier);
    EXPECT_EQ(client.hoverModifiers, Qt::NoModifier);
}

} // namespace
} // namespace kriva::ui
