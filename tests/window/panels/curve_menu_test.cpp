#include "core/document/conversion.h"
#include "tests/support/panel_test.h"
#include "ui/panels/curves_panel.h"
#include "ui/window/actions/actions.h"

#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QMenuBar>

namespace kriva::ui {
namespace {

class CurveMenuTest : public test::PanelTest, public testing::WithParamInterface<SheetIndex> {
  protected:
    CurveMenuTest()
        : PanelTest(GetParam()) {
        open({line("One"), line("Two"), line("Three")});
    }
    [[nodiscard]] Curve line(const char* name) const {
        const Points points{{0, 0}, {1, 2}, {3, 1}};
        return renamed(withPointsAdded(emptyCurve(sheet_), points), name);
    }
    [[nodiscard]] QAction& action(const char* name) {
        return *shell.window.findChild<QAction*>(QString::fromLatin1(name));
    }
    [[nodiscard]] QMenu& otherSheets() {
        for (QMenu* menu : shell.window.findChildren<QMenu*>())
            if (menu->title() == QStringLiteral("Use these &points in"))
                return *menu;
        throw std::runtime_error("no menu of the other tabs");
    }
    [[nodiscard]] std::string names() {
        std::string all;
        for (const Curve& one : editor().sheet().curves)
            all.append(nameOf(one)).append(" ");
        return all;
    }
};

TEST_P(CurveMenuTest, renamesInThePanelOfCurves) {
    auto& curves = panel<CurvesPanel>("curves");
    static_cast<QDockWidget*>(curves.parentWidget())->hide();
    QTest::keyClick(&tab.canvas(), Qt::Key_F2);
    auto* field = curves.findChild<QListView*>()->viewport()->findChild<QLineEdit*>();
    ASSERT_NE(field, nullptr);
    EXPECT_TRUE(field->isVisible());
    EXPECT_EQ(field->text(), QStringLiteral("One"));
    test::type(*field, "Blade");
    EXPECT_EQ(names(), "Blade Two Three ");
    EXPECT_EQ(steps(), QStringList(QStringLiteral("Rename the curve")));
    document().undo();
    EXPECT_EQ(names(), "One Two Three ");
}

TEST_P(CurveMenuTest, movesTheCurveInTheList) {
    EXPECT_FALSE(action("moveCurveUp").isEnabled());
    action("moveCurveDown").trigger();
    EXPECT_EQ(names(), "Two One Three ");
    action("moveCurveDown").trigger();
    EXPECT_EQ(names(), "Two Three One ");
    EXPECT_FALSE(action("moveCurveDown").isEnabled());
    action("moveCurveUp").trigger();
    EXPECT_EQ(names(), "Two One Three ");
    EXPECT_EQ(nameOf(curve()), "One");
    EXPECT_EQ(steps().size(), 3);
    EXPECT_EQ(steps().front(), QStringLiteral("Reorder the curves"));
}

TEST_P(CurveMenuTest, hidesAndShowsWithoutAStep) {
    EXPECT_TRUE(action("showCurve").isChecked());
    action("showCurve").trigger();
    EXPECT_FALSE(viewOf(curve()).isShown);
    EXPECT_FALSE(action("showCurve").isChecked());
    editor().activateNextCurve();
    EXPECT_TRUE(action("showCurve").isChecked()) << "each curve by itself";
    EXPECT_EQ(steps(), QStringList());
    EXPECT_FALSE(document().isModified());
}

TEST_P(CurveMenuTest, givesItsPointsToEveryOtherTab) {
    const Curve source = curve();
    ASSERT_EQ(otherSheets().actions().size(), static_cast<qsizetype>(kSheetCount) - 1);
    int entry = 0;
    for (SheetIndex other = 0; other < kSheetCount; ++other) {
        if (other == sheet_)
            continue;
        const std::size_t before = document().sheet(other).curves.size();
        otherSheets().actions()[entry++]->trigger();
        QApplication::processEvents();
        EXPECT_EQ(document().value().active, other) << "it is shown";
        ASSERT_EQ(document().sheet(other).curves.size(), before + 1);
        EXPECT_EQ(document().sheet(other).curves.back(), converted(source, other));
        EXPECT_EQ(shell.steps(other), 1);
        EXPECT_EQ(resolvedStep(document().history(other).text(0)), QStringLiteral("Use the points of a tab"));
        document().undo();
        EXPECT_EQ(document().sheet(other).curves.size(), before);
        shell.shown(sheet_);
    }
    EXPECT_EQ(steps(), QStringList()) << "nothing happened here";
}

TEST_P(CurveMenuTest, anEmptySheetHasNothingToDoItWith) {
    open({});
    for (const char* name : {"renameCurve", "showCurve", "moveCurveUp", "moveCurveDown", "cut", "copy", "duplicate"})
        EXPECT_FALSE(action(name).isEnabled()) << name;
    EXPECT_FALSE(otherSheets().isEnabled());
    EXPECT_TRUE(action("paste").isEnabled());
}

INSTANTIATE_TEST_SUITE_P(EachTab, CurveMenuTest, testing::Range<SheetIndex>(0, kSheetCount));

class TooManyPointsTest : public test::PanelTest {
  protected:
    TooManyPointsTest()
        : PanelTest(test::kCombined) {}
};

TEST_F(TooManyPointsTest, areRefusedByTheOtherTabAndTold) {
    CombinedCurve curve;
    for (int i = 0; i < 202; ++i)
        curve.points.push_back({static_cast<double>(i), 0});
    open({curve});
    editor().usePointsIn(test::kElevation);
    EXPECT_EQ(document().value().active, test::kCombined);
    EXPECT_TRUE(document().sheet(test::kElevation).curves.empty());
    const QString told = shell.window.findChild<QLabel*>(QStringLiteral("hint"))->text();
    EXPECT_TRUE(told.contains(QStringLiteral("201"))) << told.toStdString();
}

} // namespace
} // namespace kriva::ui
