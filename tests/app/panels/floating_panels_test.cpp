#include "tests/support/panel_test.h"
#include "ui/panels/points_panel.h"

#include <QToolButton>

namespace kriva::ui {
namespace {

/// Panels that float are windows of their own, and go with their tab.
class FloatingPanels : public testing::Test {
  protected:
    QDockWidget& dock(SheetIndex sheet, const char* name) {
        return *shell.window.tab(sheet).findChild<QDockWidget*>(QString::fromLatin1(name));
    }
    QDockWidget& floated(SheetIndex sheet, const char* name) {
        shell.shown(sheet);
        QDockWidget& floating = dock(sheet, name);
        floating.raise();
        floating.setFloating(true);
        QApplication::processEvents();
        return floating;
    }
    void show(SheetIndex sheet) {
        shell.window.document().setActiveSheet(sheet);
        QApplication::processEvents();
    }

    test::TestWindow shell;
};

TEST_F(FloatingPanels, hideAndShowWithTheirTabInAllFour) {
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        floated(sheet, "properties");
    for (const SheetIndex shown :
         {test::kSpline, test::kElevation, test::kCombined, test::kSubdivision, test::kSpline}) {
        show(shown);
        for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
            EXPECT_EQ(dock(sheet, "properties").isVisible(), sheet == shown) << shown << sheet;
            EXPECT_TRUE(dock(sheet, "properties").isFloating());
        }
    }
}

TEST_F(FloatingPanels, oneThatWasClosedStaysClosed) {
    QDockWidget& results = floated(1, "results");
    results.close();
    show(0);
    show(1);
    EXPECT_FALSE(results.isVisible());
    EXPECT_FALSE(results.toggleViewAction()->isChecked());
    results.toggleViewAction()->trigger();
    EXPECT_TRUE(results.isVisible());
}

TEST_F(FloatingPanels, sayInTheirTitlesToWhichTabTheyBelongInTheLanguage) {
    QDockWidget& points = floated(2, "points");
    EXPECT_EQ(points.windowTitle(), QStringLiteral("Points – Spline"));
    EXPECT_EQ(points.toggleViewAction()->text(), QStringLiteral("Points")) << "in the menu of its own tab";
    shell.language.setLanguage(Language::Bulgarian);
    QApplication::processEvents();
    const QString title = points.windowTitle();
    EXPECT_TRUE(title.endsWith(QStringLiteral(" – ") + shell.window.sheetTitle(test::kSpline))) << title.toStdString();
    EXPECT_FALSE(title.contains(QStringLiteral("Points")));
    points.setFloating(false);
    EXPECT_EQ(points.windowTitle(), points.toggleViewAction()->text());
    EXPECT_FALSE(points.windowTitle().contains(shell.window.sheetTitle(test::kSpline)));
}

TEST_F(FloatingPanels, aRememberedLayoutShowsThemWithTheirTabAlone) {
    floated(0, "layers");
    show(1);
    const QByteArray whileHidden = shell.window.tab(test::kElevation).panels().layout();
    EXPECT_NE(whileHidden, shell.window.tab(test::kSubdivision).panels().layout());
    test::TestWindow next;
    for (const SheetIndex sheet : {test::kSubdivision, test::kElevation})
        next.window.document().setActiveSheet(sheet);
    next.window.tab(test::kElevation).panels().setLayout(whileHidden);
    QApplication::processEvents();
    QDockWidget& layers = *next.window.tab(test::kElevation).findChild<QDockWidget*>(QStringLiteral("layers"));
    EXPECT_TRUE(layers.isFloating());
    EXPECT_TRUE(layers.isVisible());
    EXPECT_EQ(layers.windowTitle(), QStringLiteral("Layers – Elevation"));
    next.window.document().setActiveSheet(test::kCombined);
    QApplication::processEvents();
    EXPECT_FALSE(layers.isVisible());
    next.window.tab(test::kElevation).panels().setLayout(whileHidden);
    QApplication::processEvents();
    EXPECT_FALSE(layers.isVisible()) << "while its tab is hidden";
}

TEST_F(FloatingPanels, whatIsTypedWhenTheTabIsLeftIsAStepOfThatTab) {
    QDockWidget& properties = floated(1, "properties");
    properties.activateWindow();
    QApplication::processEvents();
    auto& t = test::named<NumberField>(properties, "Parameter t");
    t.setFocus();
    t.selectAll();
    QTest::keyClicks(&t, QStringLiteral("0.25"));
    QTest::keyClick(&t, Qt::Key_3, Qt::AltModifier);
    QApplication::processEvents();
    show(2);
    EXPECT_FALSE(properties.isVisible());
    const auto& curve =
        std::get<SubdivisionCurve>(shell.window.document().value().sheets[test::kSubdivision].curves[0]);
    EXPECT_EQ(curve.t, 0.25);
    EXPECT_EQ(shell.steps(test::kSubdivision), 1);
    EXPECT_EQ(shell.steps(test::kSpline), 0);
}

TEST_F(FloatingPanels, aCellThatIsOpenWhenTheTabIsLeftIsAppliedToItsOwnPoint) {
    QDockWidget& dock = floated(0, "points");
    auto& table = *dock.findChild<PointsPanel*>();
    const double y = pointAt(shell.window.document().value().sheets[test::kElevation].curves[0], 1).y;
    dock.activateWindow();
    table.setFocus();
    test::doubleClick(*table.viewport(), table.visualRect(table.model()->index(1, 0)).center());
    auto* field = table.viewport()->findChild<QLineEdit*>();
    ASSERT_NE(field, nullptr);
    QTest::keyClicks(field, QStringLiteral("-3,5"));
    show(3);
    EXPECT_EQ(pointAt(shell.window.document().value().sheets[test::kElevation].curves[0], 1), Point(-3.5, y));
    EXPECT_EQ(shell.steps(test::kElevation), 1);
    EXPECT_EQ(shell.steps(test::kCombined), 0);
}

} // namespace
} // namespace kriva::ui
