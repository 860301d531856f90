#include "core/document/document_drags.h"
#include "core/document/sheet_figure.h"
#include "tests/support/canvas_hand.h"

#include <QMenuBar>

namespace kriva::ui {
namespace {

using test::GestureTest;
using test::isNear;
using test::kCtrlAlt;
using test::kEmptyPlace;

/// The rows of the interface's table of gestures, in each tab.
class GestureTable : public GestureTest, public testing::TestWithParam<SheetIndex> {
  protected:
    GestureTable()
        : GestureTest(GetParam()) {}
    [[nodiscard]] bool isSpline() const { return GetParam() == 2; }
    [[nodiscard]] bool isOnePolynomial() const { return GetParam() < 2; }
};

TEST_P(GestureTable, aClickSelectsActivatesAndDeselects) {
    tab.editor().newCurve();
    const Serial other = tab.editor().activeSerial();
    click({2, 4});
    EXPECT_EQ(tab.editor().selectedPoints(), std::vector<int>{1});
    EXPECT_NE(tab.editor().activeSerial(), other) << "panels show the curve whose point was chosen";
    click({6, 4}, Qt::ShiftModifier);
    EXPECT_EQ(tab.editor().selectedPoints(), (std::vector<int>{1, 2}));
    click({2, 4}, Qt::ShiftModifier);
    EXPECT_EQ(tab.editor().selectedPoints(), std::vector<int>{2});
    click(kEmptyPlace);
    EXPECT_TRUE(tab.editor().selection().empty());
    document().setActiveCurve(sheet, other);
    click(middle());
    EXPECT_NE(tab.editor().activeSerial(), other);
    EXPECT_EQ(steps(), QStringList{QStringLiteral("New curve")});
}

TEST_P(GestureTable, altClickAndADoubleClickAddAtTheEnd) {
    click(kEmptyPlace, Qt::AltModifier);
    ASSERT_EQ(count(), 5);
    EXPECT_TRUE(isNear(point(4), kEmptyPlace));
    expectOneStep("Add a point");
    doubleClick({1, -1});
    ASSERT_EQ(count(), 6);
    EXPECT_TRUE(isNear(point(5), {1, -1}));
    EXPECT_EQ(steps().size(), 2);
}

TEST_P(GestureTable, altClickOnTheCurveAddsAtTheEndToo) {
    click(middle(), Qt::AltModifier);
    EXPECT_TRUE(isNear(point(4), middle()));
    expectOneStep("Add a point");
}

TEST_P(GestureTable, anEmptySheetTakesNoPointByAccident) {
    canvas.setTool(Tool::add);
    useEmptySheet();
    EXPECT_EQ(canvas.tool(), Tool::edit);
    click({1, 1});
    EXPECT_EQ(tab.editor().activeCurve(), nullptr);
    EXPECT_EQ(steps(), QStringList());
    click({1, 1}, Qt::AltModifier);
    EXPECT_EQ(count(), 1);
    EXPECT_EQ(steps(), QStringList{QStringLiteral("Add a point")});
    document().undo();
    EXPECT_EQ(tab.editor().activeCurve(), nullptr);
    doubleClick({1, 1});
    EXPECT_EQ(count(), 1);
}

TEST_P(GestureTable, newCurveAndClearArmTheAddTool) {
    for (const char* name : {"newCurve", "clearCanvas"}) {
        canvas.setTool(Tool::edit);
        action(name).trigger();
        EXPECT_EQ(canvas.tool(), Tool::add) << name;
        click({1, 1});
        EXPECT_EQ(count(), 1);
    }
}

TEST_P(GestureTable, altClickOnAPointAndDeleteRemoveIt) {
    click({2, 4}, Qt::AltModifier);
    EXPECT_EQ(count(), 3);
    expectOneStep("Remove point 1");
    document().undo();
    using Keys = std::pair<Qt::Key, Qt::KeyboardModifiers>;
    for (const auto& [key, keys] :
         {Keys(Qt::Key_Delete, {}), Keys(Qt::Key_Backspace, {}), Keys(Qt::Key_Delete, Qt::ControlModifier)}) {
        click({2, 4});
        this->key(key, keys);
        EXPECT_EQ(curve(), keys == Qt::NoModifier ? withPointsRemovedRefitted(before, {1}).edited.curve
                                                  : withPointsRemoved(before, {1}).curve);
        EXPECT_EQ(steps(), QStringList{QStringLiteral("Remove point 1")});
        document().undo();
    }
}

TEST_P(GestureTable, doubleClickAndCtrlAltClickInsertAndSelectTheNewPoint) {
    const auto expectInserted = [&] {
        ASSERT_EQ(count(), 5);
        const Edited<Curve> inserted = *withPointInserted(before, middle());
        EXPECT_EQ(tab.editor().selectedPoints(), std::vector<int>{newPointNear(inserted, middle())});
        EXPECT_EQ(steps(), QStringList{QStringLiteral("Insert a point")});
        document().undo();
        EXPECT_EQ(curve(), before);
    };
    doubleClick(middle());
    expectInserted();
    click(middle(), kCtrlAlt);
    expectInserted();
    move(middle());
    key(Qt::Key_Insert);
    expectInserted();
}

TEST_P(GestureTable, insertKeepsTheShape) {
    if (GetParam() == 3) // approximations are fitted anew
        use([&] {
            auto curve = std::get<CombinedCurve>(before);
            curve.method = CombinedCurve::Method::interpolation;
            return curve;
        }());
    const Point top = middle();
    move(middle());
    key(Qt::Key_Insert);
    const Box box = boxOf(figureOf(before, {}));
    before = curve();
    EXPECT_TRUE(isNear(isOnePolynomial() ? middle() : point(2), top));
    if (GetParam() == 3) {
        EXPECT_NEAR(box.ymax, boxOf(figureOf(before, {})).ymax, 1e-9);
    }
}

TEST_P(GestureTable, insertGoesBehindTheSelectedPointWhereThePointerIsOffTheCurve) {
    move(kEmptyPlace);
    click({0, 0});
    move(kEmptyPlace);
    key(Qt::Key_Insert);
    EXPECT_EQ(curve(), withPointInsertedBehind(before, 0)->curve);
    EXPECT_EQ(tab.editor().selectedPoints(), std::vector<int>{1});
    expectOneStep("Insert a point");
    document().undo();
    tab.editor().selectNone();
    key(Qt::Key_Insert);
    EXPECT_EQ(curve(), withPointInsertedBehind(before, {})->curve);
    EXPECT_EQ(steps().size(), 1);
    useEmptySheet();
    key(Qt::Key_Insert);
    EXPECT_EQ(steps(), QStringList());
}

TEST_P(GestureTable, aDragOfAPointMovesItOrTheSelection) {
    drag({2, 4}, {3, 5.5});
    EXPECT_TRUE(isNear(point(1), {3, 5.5}));
    expectOneStep("Move point 1");
    document().undo();
    click({2, 4});
    click({6, 4}, Qt::ShiftModifier);
    drag({6, 4}, {6, 6});
    EXPECT_TRUE(isNear(point(1), {2, 6}));
    EXPECT_TRUE(isNear(point(2), {6, 6}));
    EXPECT_EQ(steps(), QStringList{QStringLiteral("Move points")});
}

TEST_P(GestureTable, ctrlLocksAPointToAnAxisAtOnce) {
    press({2, 4});
    move({4, 5});
    EXPECT_TRUE(isNear(point(1), {4, 5}));
    hold(Qt::Key_Control);
    EXPECT_TRUE(isNear(point(1), {4, 4}));
    letGo(Qt::Key_Control, Qt::ControlModifier);
    EXPECT_TRUE(isNear(point(1), {4, 5}));
    hold(Qt::Key_Control);
    release({4, 5}, Qt::ControlModifier);
    EXPECT_TRUE(isNear(point(1), {4, 4}));
    expectOneStep("Move point 1");
}

TEST_P(GestureTable, aDragOfTheCurveMouldsItOrSaysWhyNot) {
    press(middle());
    move(middle() + Vector{0, 1});
    if (GetParam() == 3) {
        EXPECT_EQ(hint(), QStringLiteral("This curve follows its points; drag them"));
        release(middle() + Vector{0, 1});
        return expectNoStep();
    }
    release(middle() + Vector{0, 1});
    const Point grabbed = middle();
    const Curve moulded = curve();
    expectOneStep("Mould the curve");
    before = moulded;
    EXPECT_TRUE(isNear(middle(), grabbed + Vector{0, 1})) << "the grabbed place stays under the pointer";
}

TEST_P(GestureTable, theRubberBandSelectsAddsAndSubtracts) {
    drag({-1, -1}, {3, 5});
    EXPECT_EQ(tab.editor().selectedPoints(), (std::vector<int>{0, 1}));
    drag({5, 5}, {7, 3.5}, Qt::ShiftModifier);
    EXPECT_EQ(tab.editor().selectedPoints(), (std::vector<int>{0, 1, 2}));
    drag({-1, -1}, {1, 1}, Qt::ShiftModifier | Qt::ControlModifier);
    EXPECT_EQ(tab.editor().selectedPoints(), (std::vector<int>{1, 2}));
    drag({5, 5}, {7, 3.5}, Qt::AltModifier);
    EXPECT_EQ(tab.editor().selectedPoints(), std::vector<int>{1});
    expectNoStep();
}

TEST_P(GestureTable, arrowsNudgeInOneStep) {
    click({2, 4});
    key(Qt::Key_Right);
    key(Qt::Key_Right, Qt::ShiftModifier);
    key(Qt::Key_Up, Qt::AltModifier);
    EXPECT_GT(point(1).x, 2);
    EXPECT_NEAR(point(1).y, 4 + 1.0 / 40, 1e-12);
    expectOneStep("Nudge");
}

TEST_P(GestureTable, tabWalksAndEscLeavesStepByStep) {
    key(Qt::Key_Tab);
    key(Qt::Key_Tab);
    EXPECT_EQ(tab.editor().selectedPoints(), std::vector<int>{1});
    key(Qt::Key_Backtab, Qt::ShiftModifier);
    EXPECT_EQ(tab.editor().selectedPoints(), std::vector<int>{0});
    canvas.setTool(Tool::add);
    press({2, 4});
    move({3, 5});
    key(Qt::Key_Escape);
    release({3, 5});
    expectNoStep();
    EXPECT_EQ(canvas.tool(), Tool::add);
    key(Qt::Key_Escape);
    EXPECT_EQ(canvas.tool(), Tool::edit);
    key(Qt::Key_Escape);
    EXPECT_TRUE(tab.editor().selection().empty());
    key(Qt::Key_Escape);
    EXPECT_FALSE(canvas.hasFocus());
}

TEST_P(GestureTable, theRightButtonTakesAnyDragBack) {
    const auto take = [&](Point from, Qt::KeyboardModifiers keys = {}) {
        press(from, keys);
        move(from + Vector{1, 1}, keys);
        press(from + Vector{1, 1}, keys, Qt::RightButton);
        release(from + Vector{1, 1}, keys, Qt::RightButton);
        release(from + Vector{1, 1}, keys);
        EXPECT_EQ(canvas.findChild<QMenu*>(QStringLiteral("contextMenu")), nullptr);
        expectNoStep();
    };
    take({2, 4});
    take(middle());
    take(kEmptyPlace, Qt::ShiftModifier);
    canvas.setTool(Tool::add);
    take(kEmptyPlace);
    take(middle());
}

TEST_P(GestureTable, pageUpAndPageDownStepTheNumberOfTheTab) {
    const auto number = [&] { return window.sheets[sheet].number.value(curve()); };
    const int first = number();
    key(Qt::Key_PageUp);
    EXPECT_EQ(number(), first + 1);
    key(Qt::Key_PageUp);
    key(Qt::Key_PageDown);
    constexpr const char* kNames[] = {"Raise the degree", "Set the levels", "Set the degree", "Set the degree"};
    expectOneStep(kNames[GetParam()]);
    for (int i = 0; i < 12; ++i)
        key(Qt::Key_PageDown);
    constexpr int kLeast[] = {0, 0, 2, 1};
    EXPECT_EQ(number(), kLeast[GetParam()]);
    EXPECT_FALSE(action("lowerNumber").isEnabled());
}

TEST_P(GestureTable, altAloneLeavesTheFocusOnTheCanvas) {
    hold(Qt::Key_Alt);
    letGo(Qt::Key_Alt, Qt::AltModifier);
    QApplication::processEvents();
    EXPECT_TRUE(canvas.hasFocus());
    EXPECT_EQ(window.window.menuBar()->activeAction(), nullptr);
}

TEST_P(GestureTable, theGhostShowsWhereAPointWouldCome) {
    move(middle());
    EXPECT_EQ(canvas.scene().ghost(), std::nullopt);
    hold(Qt::Key_Control);
    hold(Qt::Key_Alt, Qt::ControlModifier);
    ASSERT_TRUE(canvas.scene().ghost());
    const Point ghost = *canvas.scene().ghost();
    EXPECT_TRUE(isOnePolynomial() || isNear(ghost, middle()));
    letGo(Qt::Key_Alt, kCtrlAlt);
    EXPECT_EQ(canvas.scene().ghost(), std::nullopt);
    key(Qt::Key_B);
    EXPECT_EQ(canvas.scene().ghost(), ghost) << "with the tool, before the mouse moves";
    const QImage with = canvas.grab().toImage();
    move(kEmptyPlace);
    EXPECT_EQ(canvas.scene().ghost(), std::nullopt);
    EXPECT_NE(canvas.grab().toImage(), with);
    click(middle());
    EXPECT_EQ(pointAt(curve(), tab.editor().selectedPoints().front()), ghost);
    EXPECT_TRUE(isOnePolynomial() || !canvas.scene().ghost()) << "the pointer is on the new point";
}

INSTANTIATE_TEST_SUITE_P(InEachTab, GestureTable, testing::Range<SheetIndex>(0, kSheetCount));

} // namespace
} // namespace kriva::ui
