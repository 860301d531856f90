#include "core/document/document_drags.h"
#include "tests/support/canvas_hand.h"

#include <QContextMenuEvent>
#include <QMenu>

namespace kriva::ui {
namespace {

using test::GestureTest;
using test::kEmptyPlace;

class ContextMenu : public GestureTest, public testing::TestWithParam<SheetIndex> {
  protected:
    ContextMenu()
        : GestureTest(GetParam()) {}

    QMenu& menu() { return *canvas.findChild<QMenu*>(QStringLiteral("contextMenu")); }
    QMenu& askAt(Point at) {
        click(at, {}, Qt::RightButton);
        return menu();
    }
    /// Chooses an entry as a click would, and lets the menu go.
    void choose(const char* name) {
        QAction& wanted = action(name);
        QMenu& open = menu();
        ASSERT_TRUE(open.actions().contains(&wanted)) << name;
        ASSERT_TRUE(wanted.isEnabled()) << name;
        QTest::mouseClick(&open, Qt::LeftButton, {}, open.actionGeometry(&wanted).center());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QApplication::processEvents();
        EXPECT_EQ(canvas.findChild<QMenu*>(QStringLiteral("contextMenu")), nullptr);
    }
};

TEST_P(ContextMenu, onAPointIsAboutThatPoint) {
    askAt({2, 4});
    EXPECT_EQ(tab.editor().selectedPoints(), std::vector<int>{1});
    choose("deleteSelected");
    expectOneStep("Remove point 1");
}

TEST_P(ContextMenu, onASelectedPointIsAboutTheSelection) {
    click({2, 4});
    click({6, 4}, Qt::ShiftModifier);
    askAt({2, 4});
    choose("deleteSelected");
    EXPECT_EQ(count(), 2);
    expectOneStep("Remove points");
}

TEST_P(ContextMenu, onACurveInsertsThere) {
    askAt(middle());
    choose("insertPoint");
    const Viewport& seen = canvas.mapping();
    const Point pixel = canvas.mapping().toDocument(seen.toPixels(middle()).toPoint());
    EXPECT_EQ(curve(), withPointInserted(before, pixel)->curve);
    expectOneStep("Insert a point");
    document().undo();
    tab.editor().selectNone();
    action("insertPoint").trigger();
    EXPECT_EQ(curve(), withPointInsertedBehind(before, {})->curve) << "the menu is closed";
}

TEST_P(ContextMenu, onACurveMakesItActive) {
    tab.editor().newCurve();
    askAt(middle());
    choose("duplicateCurve");
    EXPECT_EQ(steps().last(), QStringLiteral("Duplicate the curve"));
    EXPECT_EQ(curve(), before);
}

TEST_P(ContextMenu, onEmptyCanvasIsAboutTheSheetAndTheView) {
    click({2, 4});
    askAt(kEmptyPlace);
    EXPECT_EQ(tab.editor().selectedPoints(), std::vector<int>{1}) << "it deselects nothing";
    EXPECT_FALSE(menu().actions().contains(&action("deleteSelected")));
    choose("newCurve");
    EXPECT_EQ(steps(), QStringList{QStringLiteral("New curve")});
}

TEST_P(ContextMenu, theMenuKeyAsksForTheSelectedPoint) {
    click({6, 4});
    QContextMenuEvent event(QContextMenuEvent::Keyboard, QPoint(1, 1), canvas.mapToGlobal(QPoint(1, 1)));
    QApplication::sendEvent(&canvas, &event);
    choose("deleteSelected");
    expectOneStep("Remove point 2");
}

TEST_P(ContextMenu, aDragWithTheRightButtonAsksForNothing) {
    press({2, 4}, {}, Qt::RightButton);
    move({3, 5});
    release({3, 5}, {}, Qt::RightButton);
    EXPECT_EQ(canvas.findChild<QMenu*>(QStringLiteral("contextMenu")), nullptr);
    expectNoStep();
}

TEST_P(ContextMenu, showsTheActionsOfTheMenuBarAndNoCopies) {
    for (const Point at : {Point{2, 4}, middle(), kEmptyPlace}) {
        for (const QAction* entry : askAt(at).actions())
            EXPECT_TRUE(entry->isSeparator() || entry->parent() != &menu()) << entry->text().toStdString();
        menu().close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

INSTANTIATE_TEST_SUITE_P(InEachTab, ContextMenu, testing::Range<SheetIndex>(0, kSheetCount));

class SplineContextMenu : public ContextMenu {};

TEST_P(SplineContextMenu, onAHandleIsAboutThatHandle) {
    auto held = std::get<SplineCurve>(before);
    held.knots[1] = {{2, 4}, SplineKnot::Join::smooth, Point{1, 3}, Point{4, 6}};
    use(held);
    askAt({4, 6});
    choose("retractHandles");
    EXPECT_EQ(knot(1).out, knot(1).at);
    EXPECT_EQ(knot(1).in, (Point{1, 3}));
    expectOneStep("Retract the handles");
}

TEST_P(SplineContextMenu, onAKnotSetsItsJoinAndOnTheCurveClosesIt) {
    askAt({2, 4});
    choose("corner");
    EXPECT_EQ(knot(1).join, SplineKnot::Join::corner);
    askAt(middle());
    choose("closed");
    EXPECT_EQ(steps(), (QStringList{QStringLiteral("Set the join"), QStringLiteral("Close the curve")}));
}

INSTANTIATE_TEST_SUITE_P(OfSplines, SplineContextMenu, testing::Values(SheetIndex{2}));

} // namespace
} // namespace kriva::ui
