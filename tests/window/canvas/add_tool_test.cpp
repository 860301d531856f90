#include "core/document/document_drags.h"
#include "core/sheets/spline/editing/chain_edits.h"
#include "tests/support/canvas_hand.h"

namespace kriva::ui {
namespace {

using test::GestureTest;
using test::isNear;
using test::kEmptyPlace;
using Join = SplineKnot::Join;

class AddToolInEachTab : public GestureTest, public testing::TestWithParam<SheetIndex> {
  protected:
    AddToolInEachTab()
        : GestureTest(GetParam()) {
        canvas.setTool(Tool::add);
    }
    [[nodiscard]] bool isSpline() const { return GetParam() == 2; }
};

TEST_P(AddToolInEachTab, clicksAddAndInsert) {
    click(kEmptyPlace);
    EXPECT_TRUE(isNear(point(4), kEmptyPlace));
    expectOneStep("Add a point");
    document().undo();
    click(middle());
    EXPECT_EQ(curve(),
              withPointInserted(before, canvas.mapping().toDocument(canvas.mapping().toPixels(middle())))->curve);
    EXPECT_EQ(steps(), QStringList{QStringLiteral("Insert a point")});
    EXPECT_EQ(canvas.tool(), Tool::add);
}

TEST_P(AddToolInEachTab, aDragAddsAPointAndPullsItsHandlesOrPlacesIt) {
    drag(kEmptyPlace, kEmptyPlace + Vector{1, -0.5});
    ASSERT_EQ(count(), 5);
    EXPECT_TRUE(isNear(point(4), isSpline() ? kEmptyPlace : kEmptyPlace + Vector{1, -0.5}));
    expectOneStep("Add a point");
}

TEST_P(AddToolInEachTab, aDragOnTheCurveInsertsAPointAndPullsItsHandlesOrPlacesIt) {
    const Edited<Curve> inserted = *withPointInserted(before, middle());
    const int added = newPointNear(inserted, middle());
    const Point place = pointAt(inserted.curve, added);
    drag(middle(), middle() + Vector{1, 0.5});
    ASSERT_EQ(count(), 5);
    EXPECT_EQ(tab.editor().selectedPoints(), std::vector<int>{added});
    EXPECT_TRUE(isNear(point(added), isSpline() ? place : place + Vector{1, 0.5}));
    expectOneStep("Insert a point");
    document().undo();
    press(middle());
    move(middle() + Vector{1, 0.5});
    key(Qt::Key_Escape);
    release(middle());
    EXPECT_EQ(curve(), before);
    EXPECT_TRUE(document().history(sheet).canRedo());
}

TEST_P(AddToolInEachTab, aDragThatComesHomeIsAClick) {
    press(kEmptyPlace);
    move(kEmptyPlace + Vector{1, 1});
    move(kEmptyPlace);
    release(kEmptyPlace);
    EXPECT_EQ(curve(), withPointAdded(before, point(4)).curve);
    expectOneStep("Add a point");
}

TEST_P(AddToolInEachTab, aClickOnAnyButTheFirstKnotAddsAPoint) {
    click({6, 4});
    EXPECT_EQ(count(), 5);
    EXPECT_EQ(canvas.tool(), Tool::add);
    expectOneStep("Add a point");
}

INSTANTIATE_TEST_SUITE_P(InEachTab, AddToolInEachTab, testing::Range<SheetIndex>(0, kSheetCount));

class AddToolOnSplines : public GestureTest, public testing::Test {
  protected:
    AddToolOnSplines()
        : GestureTest(test::kSpline) {
        canvas.setTool(Tool::add);
    }
};

TEST_F(AddToolOnSplines, theOutHandleOfANewKnotIsUnderThePointerAndTheInHandleMirrorsIt) {
    press(kEmptyPlace);
    move({5, -1.5});
    EXPECT_EQ(knot(4).join, Join::symmetric);
    EXPECT_TRUE(isNear(*knot(4).out, {5, -1.5}));
    EXPECT_TRUE(isNear(*knot(4).in, {3, -0.5}));
    hold(Qt::Key_Control);
    EXPECT_NEAR(knot(4).out->y - knot(4).at.y, -(knot(4).out->x - knot(4).at.x) * std::tan(std::atan(1) * 2 / 3), 1e-9);
    letGo(Qt::Key_Control, Qt::ControlModifier);
    hold(Qt::Key_Alt);
    move({4, -2}, Qt::AltModifier);
    EXPECT_EQ(knot(4).join, Join::corner);
    EXPECT_TRUE(isNear(*knot(4).in, {3, -0.5})) << "it stays where it was when Alt went down";
    release({4, -2}, Qt::AltModifier);
    expectOneStep("Add a point");
    click({2, -2});
    EXPECT_TRUE(isNear(*knot(4).out, {4, -2})) << "the next segment leaves along it";
}

TEST_F(AddToolOnSplines, theFirstKnotOfAnEmptySheetCanBePulled) {
    useEmptySheet();
    canvas.setTool(Tool::add);
    drag({1, 1}, {2, 2});
    EXPECT_TRUE(isNear(*knot(0).out, {2, 2}));
    drag({4, 1}, {5, 1});
    EXPECT_EQ(count(), 2);
    EXPECT_EQ(steps(), (QStringList{QStringLiteral("Add a point"), QStringLiteral("Add a point")}));
}

TEST_F(AddToolOnSplines, aKnotInsertedByADragIsPulledAroundItsPlaceOnTheCurve) {
    const Point place = middle();
    drag(place, place + Vector{1, 1});
    EXPECT_EQ(knot(2).join, Join::symmetric);
    EXPECT_TRUE(isNear(*knot(2).out, place + Vector{1, 1}));
    EXPECT_TRUE(isNear(*knot(2).in, place - Vector{1, 1}));
}

TEST_F(AddToolOnSplines, knotsOfParabolasFollowThePointer) {
    use(withDegree(spline(), 2));
    canvas.setTool(Tool::add);
    drag(kEmptyPlace, {5, -1.5});
    EXPECT_TRUE(isNear(point(4), {5, -1.5}));
    expectOneStep("Add a point");
}

TEST_F(AddToolOnSplines, aClickOnTheFirstKnotClosesTheChainAndEndsTheTool) {
    move({0, 0});
    EXPECT_TRUE(hint().startsWith(QStringLiteral("Click: close the curve")));
    click({0, 0});
    EXPECT_TRUE(spline().closed);
    EXPECT_EQ(count(), 4);
    EXPECT_EQ(canvas.tool(), Tool::edit);
    expectOneStep("Close the curve");
    canvas.setTool(Tool::add);
    click({0, 0});
    EXPECT_EQ(count(), 5) << "it is closed already";
}

TEST_F(AddToolOnSplines, twoKnotsAreNotClosed) {
    use(withPointsRemoved(before, {2, 3}).curve);
    canvas.setTool(Tool::add);
    click({0, 0});
    EXPECT_EQ(count(), 3);
    EXPECT_FALSE(spline().closed);
}

TEST_F(AddToolOnSplines, enterAndEscEndIt) {
    key(Qt::Key_Return);
    EXPECT_EQ(canvas.tool(), Tool::edit);
    key(Qt::Key_B);
    key(Qt::Key_Escape);
    EXPECT_EQ(canvas.tool(), Tool::edit);
    expectNoStep();
}

} // namespace
} // namespace kriva::ui
