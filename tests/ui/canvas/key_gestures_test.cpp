#include "tests/ui/canvas/canvas_fixture.h"

#include <QAction>
#include <QLineEdit>
#include <QSignalSpy>
#include <QVBoxLayout>

namespace kriva::ui {
namespace {

class KeyGesture : public CanvasTest {};

TEST_F(KeyGesture, deleteRemovesTheSelection) {
    key(Qt::Key_Delete);
    EXPECT_EQ(calls(), QStringList()) << "nothing is selected";
    view.scene().setSelection({point(1)});
    key(Qt::Key_Delete);
    key(Qt::Key_Backspace);
    key(Qt::Key_Delete, Qt::ControlModifier);
    EXPECT_EQ(calls(), list({"remove selected", "remove selected", "remove selected plainly"}));
}

TEST_F(KeyGesture, arrowsNudgeByOneStepTenStepsOrOnePixel) {
    key(Qt::Key_Right);
    EXPECT_EQ(calls(), QStringList()) << "nothing is selected";
    view.scene().setSelection({point(1)});
    key(Qt::Key_Right); // the grid's step is 20 units at a pixel to a unit
    key(Qt::Key_Up, Qt::ShiftModifier);
    key(Qt::Key_Down, Qt::AltModifier);
    key(Qt::Key_Left, Qt::KeypadModifier);
    EXPECT_EQ(calls(), list({"nudge 20,0", "nudge 0,200", "nudge 0,-1", "nudge -20,0"}));
}

TEST_F(KeyGesture, escEndsTheAddToolThenTheSelection) {
    view.scene().setSelection({point(1)});
    view.setTool(Tool::add);
    key(Qt::Key_Escape);
    EXPECT_EQ(view.tool(), Tool::edit);
    EXPECT_EQ(calls(), QStringList());
    key(Qt::Key_Escape);
    EXPECT_EQ(calls(), list({"select"}));
}

TEST_F(KeyGesture, singleKeysChooseToolsGridAndView) {
    QSignalSpy tools(&view, &CanvasView::toolChanged);
    QSignalSpy grids(&view.scene(), &CanvasScene::gridShownChanged);
    key(Qt::Key_B);
    EXPECT_EQ(view.tool(), Tool::add);
    key(Qt::Key_V);
    EXPECT_EQ(view.tool(), Tool::edit);
    key(Qt::Key_B);
    key(Qt::Key_Return);
    EXPECT_EQ(view.tool(), Tool::edit);
    EXPECT_EQ(tools.size(), 4);
    key(Qt::Key_G);
    EXPECT_FALSE(view.scene().isGridShown());
    EXPECT_EQ(grids.size(), 1);
    view.scene().setSelection({point(1), point(2)});
    key(Qt::Key_3);
    EXPECT_EQ(view.mapping().centre, (Point{50, 50}));
}

TEST_F(KeyGesture, actionsOfTheCanvasAreTriggeredByTheirKeys) {
    QAction corner;
    corner.setShortcut(Qt::SHIFT | Qt::Key_C);
    corner.setShortcutContext(Qt::WidgetShortcut);
    QSignalSpy triggered(&corner, &QAction::triggered);
    view.addAction(&corner);
    key(Qt::Key_C, Qt::ShiftModifier);
    key(Qt::Key_C);
    EXPECT_EQ(triggered.size(), 1);
}

TEST_F(KeyGesture, insertGoesWhereThePointerIsOnACurveElseToTheSelection) {
    key(Qt::Key_Insert);
    move({0, 50});
    key(Qt::Key_Insert);
    move({0, -100});
    key(Qt::Key_Insert);
    EXPECT_EQ(calls(), list({"insert", "insert into 1 0,50", "insert"}));
}

TEST_F(KeyGesture, keysWaitWhileAButtonIsDown) {
    view.scene().setSelection({point(1)});
    press({0, 100});
    move({0, 120});
    calls();
    key(Qt::Key_Delete);
    key(Qt::Key_Left);
    key(Qt::Key_Tab);
    EXPECT_EQ(calls(), QStringList());
    release({0, 120});
}

TEST_F(KeyGesture, keysOfTheCanvasAreNotTakenByShortcutsAndOthersAre) {
    const auto isTaken = [this](Qt::Key key, Qt::KeyboardModifiers modifiers) {
        QKeyEvent event(QEvent::ShortcutOverride, key, modifiers);
        event.ignore();
        QApplication::sendEvent(&view, &event);
        return event.isAccepted();
    };
    EXPECT_TRUE(isTaken(Qt::Key_Delete, {}));
    EXPECT_TRUE(isTaken(Qt::Key_Left, Qt::AltModifier));
    EXPECT_TRUE(isTaken(Qt::Key_V, {}));
    EXPECT_FALSE(isTaken(Qt::Key_V, Qt::ControlModifier));
    EXPECT_FALSE(isTaken(Qt::Key_1, Qt::AltModifier));
    EXPECT_FALSE(isTaken(Qt::Key_Return, {})) << "only the Add tool ends with it";
}

/// The canvas between two fields.
class KeyWalk : public CanvasTest {
  protected:
    KeyWalk() {
        auto* layout = new QVBoxLayout(&window);
        layout->addWidget(before);
        layout->addWidget(&view);
        layout->addWidget(after);
        window.resize(400, 400);
        QWidget::setTabOrder(before, &view);
        QWidget::setTabOrder(&view, after);
        view.show();
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
        view.setFocus();
        view.fitAll();
    }
    ~KeyWalk() override { view.setParent(nullptr); }

    QWidget window;
    QLineEdit* before = new QLineEdit(&window);
    QLineEdit* after = new QLineEdit(&window);
};

TEST_F(KeyWalk, tabWalksThroughThePointsAndLeavesPastTheLast) {
    for (int i = 0; i < 3; ++i)
        key(Qt::Key_Tab);
    EXPECT_EQ(calls(), list({"select 1:0", "select 1:1", "select 1:2"}));
    EXPECT_TRUE(view.hasFocus());
    key(Qt::Key_Tab);
    EXPECT_TRUE(after->hasFocus());
    EXPECT_EQ(calls(), QStringList());

    view.setFocus();
    key(Qt::Key_Tab);
    EXPECT_EQ(calls(), list({"select 1:0"})) << "the next walk starts anew";
}

TEST_F(KeyWalk, shiftTabWalksBackwards) {
    view.scene().setSelection({point(1)});
    key(Qt::Key_Backtab, Qt::ShiftModifier);
    EXPECT_EQ(calls(), list({"select 1:0"}));
    key(Qt::Key_Backtab, Qt::ShiftModifier);
    EXPECT_TRUE(before->hasFocus());
}

TEST_F(KeyWalk, theWalkScrollsToThePoint) {
    Viewport far = view.mapping();
    far.centre = {1e6, 1e6};
    view.setMapping(far);
    key(Qt::Key_Tab);
    EXPECT_TRUE(QRectF(view.viewport()->rect()).contains(view.mapping().toPixels({-100, 0})));
}

TEST_F(KeyWalk, escLeavesTheCanvasAtLast) {
    key(Qt::Key_Escape);
    EXPECT_TRUE(after->hasFocus());
}

} // namespace
} // namespace kriva::ui
