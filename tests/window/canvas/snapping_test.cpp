#include "tests/support/panel_test.h"

#include <QMouseEvent>

namespace kriva::ui {
namespace {

/// Two polygons in a sheet: (0, 0) (1, 1) (3, 0) is active, (4, 2) (6, 2) beside it, at 100 pixels to the unit, so that
/// the grid's step is 0.2.
class SnappingTest : public test::PanelTest, public testing::WithParamInterface<SheetIndex> {
  protected:
    SnappingTest()
        : PanelTest(GetParam()) {
        const Points active{{0, 0}, {1, 1}, {3, 0}};
        const Points other{{4.05, 2.05}, {6, 2.05}};
        open({withPointsAdded(emptyCurve(sheet_), active), withPointsAdded(emptyCurve(sheet_), other)});
        Viewport mapping = canvas().mapping();
        mapping.scale = 100;
        mapping.centre = {3, 1};
        canvas().setMapping(mapping);
        canvas().setFocus();
    }
    ~SnappingTest() override {
        if (action()->isChecked())
            action()->trigger();
    }
    CanvasView& canvas() { return tab.canvas(); }
    [[nodiscard]] QAction* action() { return shell.window.findChild<QAction*>(QStringLiteral("snap")); }
    void snapOn() { QTest::keyClick(&canvas(), Qt::Key_N); }
    [[nodiscard]] QPointF pixel(Point at) { return canvas().mapping().toPixels(at); }
    void press(Point at, Qt::KeyboardModifiers keys = {}) { send(QEvent::MouseButtonPress, at, Qt::LeftButton, keys); }
    void move(Point at, Qt::KeyboardModifiers keys = {}) { send(QEvent::MouseMove, at, Qt::NoButton, keys); }
    void release(Point at, Qt::KeyboardModifiers keys = {}) {
        send(QEvent::MouseButtonRelease, at, Qt::LeftButton, keys);
    }
    void send(QEvent::Type type, Point at, Qt::MouseButton button, Qt::KeyboardModifiers keys) {
        const QPointF local = pixel(at);
        const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
        QMouseEvent event(type, local, canvas().viewport()->mapToGlobal(local), button, held, keys);
        QApplication::sendEvent(canvas().viewport(), &event);
    }
    void drag(Point from, Point to, Qt::KeyboardModifiers keys = {}) {
        press(from, keys & Qt::KeyboardModifiers(Qt::ShiftModifier));
        move(to, keys);
        release(to, keys);
    }
    [[nodiscard]] Point point(int index) { return pointAt(curve(), index); }
};

TEST_P(SnappingTest, isOffAtFirst) {
    drag({1, 1}, {1.43, 1.27});
    EXPECT_NEAR(distance(point(1), {1.43, 1.27}), 0, 1e-9);
}

TEST_P(SnappingTest, theKeyTurnsItOnForAllTabsAndIsRemembered) {
    snapOn();
    EXPECT_TRUE(action()->isChecked());
    EXPECT_TRUE(Preferences().isSnapping());
    snapOn();
    EXPECT_FALSE(action()->isChecked());
    EXPECT_FALSE(Preferences().isSnapping());
}

TEST_P(SnappingTest, aDraggedPointComesToTheGridInOneStep) {
    const Curve before = curve();
    snapOn();
    drag({1, 1}, {1.43, 1.27});
    EXPECT_EQ(point(1), (Point{1.4, 1.2}));
    EXPECT_EQ(steps(), QStringList(QStringLiteral("Move point 1")));
    document().undo();
    EXPECT_EQ(curve(), before);
}

TEST_P(SnappingTest, outAndBackIsNoStepThoughHomeIsOffTheGrid) {
    drag({1, 1}, {1.43, 1.27});
    document().history(sheet_).clear();
    const Curve before = curve();
    snapOn();
    press({1.43, 1.27});
    move({2, 2});
    EXPECT_NE(curve(), before);
    move({1.43, 1.27});
    release({1.43, 1.27});
    expectNoStep(before);
}

TEST_P(SnappingTest, pointsOfOtherCurvesWin) {
    snapOn();
    drag({1, 1}, {4.11, 2});
    EXPECT_EQ(point(1), (Point{4.05, 2.05}));
}

TEST_P(SnappingTest, theRestOfTheSelectionFollows) {
    snapOn();
    selectPoints({0, 1});
    drag({1, 1}, {4.11, 2});
    EXPECT_EQ(point(1), (Point{4.05, 2.05}));
    EXPECT_NEAR(distance(point(0), {3.05, 1.05}), 0, 1e-12);
    EXPECT_EQ(steps(), QStringList(QStringLiteral("Move points")));
}

TEST_P(SnappingTest, ctrlKeepsToAnAxis) {
    snapOn();
    drag({1, 1}, {1.43, 1.11}, Qt::ControlModifier);
    EXPECT_EQ(point(1), (Point{1.4, 1}));
}

TEST_P(SnappingTest, shiftPressedDuringTheDragSwitchesItOffForTheMoment) {
    snapOn();
    press({1, 1});
    move({1.43, 1.27});
    EXPECT_EQ(point(1), (Point{1.4, 1.2}));
    move({1.43, 1.27}, Qt::ShiftModifier);
    EXPECT_NEAR(distance(point(1), {1.43, 1.27}), 0, 1e-9);
    move({1.43, 1.27});
    EXPECT_EQ(point(1), (Point{1.4, 1.2}));
    release({1.43, 1.27});
}

TEST_P(SnappingTest, shiftHeldSinceBeforeTheDragAddedToTheSelection) {
    snapOn();
    drag({1, 1}, {1.43, 1.27}, Qt::ShiftModifier);
    EXPECT_EQ(point(1), (Point{1.4, 1.2}));
}

TEST_P(SnappingTest, anAddedPointComesToTheGrid) {
    snapOn();
    send(QEvent::MouseButtonPress, {2.23, 2.77}, Qt::LeftButton, Qt::AltModifier);
    release({2.23, 2.77}, Qt::AltModifier);
    EXPECT_EQ(point(3), (Point{2.2, 2.8}));
    EXPECT_EQ(steps(), QStringList(QStringLiteral("Add a point")));
}

TEST_P(SnappingTest, nudgingGoesByStepsAndDoesNotSnap) {
    drag({1, 1}, {1.43, 1.27});
    snapOn();
    selectPoints({1});
    const Point before = point(1);
    QTest::keyClick(&canvas(), Qt::Key_Right);
    EXPECT_NEAR(distance(point(1), before + Vector{0.2, 0}), 0, 1e-12);
}

TEST_P(SnappingTest, aMarkShowsThePlaceWhileTheDragLasts) {
    snapOn();
    const auto picture = [&] { return canvas().grab().toImage(); };
    press({1, 1});
    move({1.43, 1.27}, Qt::ShiftModifier);
    move({1.4, 1.2});
    const QImage marked = picture();
    release({1.4, 1.2});
    // One arm of the plus, beyond the marks of the point itself.
    const QPointF at = pixel({1.4, 1.2});
    const QPoint arm(static_cast<int>(at.x()), static_cast<int>(at.y()) - 9);
    EXPECT_NE(marked.pixelColor(arm), picture().pixelColor(arm));
}

INSTANTIATE_TEST_SUITE_P(EachTab, SnappingTest, testing::Range<SheetIndex>(0, kSheetCount));

} // namespace
} // namespace kriva::ui
