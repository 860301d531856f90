#include "tests/support/canvas_hand.h"

namespace kriva::ui {
namespace {

/// File > New from each tab.
class NewDocument : public test::GestureTest, public testing::TestWithParam<SheetIndex> {
  protected:
    NewDocument()
        : GestureTest(GetParam()) {}
};

TEST_P(NewDocument, staysInTheTabAndTakesNoPointByAccident) {
    canvas.setTool(Tool::add);
    action("new").trigger();
    QApplication::processEvents();
    EXPECT_EQ(document().value().active, GetParam());
    EXPECT_TRUE(canvas.isVisible());
    for (SheetIndex i = 0; i < kSheetCount; ++i) {
        EXPECT_TRUE(document().sheet(i).curves.empty());
        EXPECT_EQ(window.window.tab(i).canvas().tool(), Tool::edit);
    }
    EXPECT_TRUE(action("editTool").isChecked());
    click({1, 1});
    EXPECT_EQ(tab.editor().activeCurve(), nullptr);
    EXPECT_FALSE(document().isModified());
    EXPECT_EQ(document().histories().activeStack(), &document().history(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(InEachTab, NewDocument, testing::Range<SheetIndex>(0, kSheetCount));

} // namespace
} // namespace kriva::ui
