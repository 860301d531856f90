#include "tests/support/panel_test.h"
#include "ui/panels/curves_panel.h"

namespace kriva::ui {
namespace {

using test::click;
using test::named;

class CurvesPanelTest : public test::PanelTest {
  protected:
    CurvesPanelTest()
        : PanelTest(test::kSpline) {
        open({chain("First", 2), chain("", 3), chain("Third", 4)});
    }
    static SplineCurve chain(const char* name, int knots) {
        SplineCurve curve;
        curve.name = name;
        for (int i = 0; i < knots; ++i)
            curve.knots.push_back({{static_cast<double>(i), static_cast<double>(i % 2)}, {}, {}, {}});
        return curve;
    }
    [[nodiscard]] QToolButton& button(const char* name) { return named<QToolButton>(curves, name); }
    void clickRow(int row) {
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(index(row)).center());
    }
    [[nodiscard]] QModelIndex index(int row) { return list.model()->index(row, 0); }
    [[nodiscard]] QStringList rows() {
        QStringList texts;
        for (int row = 0; row < list.model()->rowCount(); ++row)
            texts.append(index(row).data().toString());
        return texts;
    }
    [[nodiscard]] int active() { return editor().sheet().view.activeCurve; }
    /// The one step so far has that name, and undo brings the rows back.
    void expectOneStepOfRows(const char* name, const QStringList& after) {
        EXPECT_EQ(rows(), after);
        EXPECT_EQ(steps(), QStringList(QString::fromUtf8(name)));
        document().undo();
        EXPECT_EQ(rows(), before);
    }

    const QStringList before{QStringLiteral("First"), QStringLiteral("Curve 2"), QStringLiteral("Third")};
    CurvesPanel& curves = panel<CurvesPanel>("curves");
    QListView& list = *curves.findChild<QListView*>();
};

TEST_F(CurvesPanelTest, aChosenRowIsTheActiveCurve) {
    clickRow(2);
    EXPECT_EQ(active(), 2);
    QTest::keyClick(&list, Qt::Key_Up);
    EXPECT_EQ(active(), 1);
    document().setActiveCurve(test::kSpline, document().serials(test::kSpline)[0]);
    EXPECT_EQ(list.currentIndex().row(), 0);
    EXPECT_EQ(steps(), QStringList());
    EXPECT_FALSE(document().isModified());
}

TEST_F(CurvesPanelTest, renamesInOneStep) {
    test::doubleClick(*list.viewport(), list.visualRect(index(1)).center());
    auto* field = list.viewport()->findChild<QLineEdit*>();
    ASSERT_NE(field, nullptr);
    EXPECT_EQ(field->text(), QString()); // the number is no name
    test::type(*field, "Blade");
    expectOneStepOfRows("Rename the curve", {before[0], QStringLiteral("Blade"), before[2]});
}

TEST_F(CurvesPanelTest, hidesACurveWithoutAStep) {
    clickRow(1);
    QTest::keyClick(&list, Qt::Key_Space);
    EXPECT_FALSE(viewOf(editor().sheet().curves[1]).isShown);
    EXPECT_EQ(index(1).data(Qt::CheckStateRole).toInt(), Qt::Unchecked);
    EXPECT_EQ(steps(), QStringList());
    EXPECT_FALSE(document().isModified());
    QTest::keyClick(&list, Qt::Key_Space);
    EXPECT_TRUE(viewOf(editor().sheet().curves[1]).isShown);
}

TEST_F(CurvesPanelTest, addsACurveWhichBecomesActive) {
    click(button("New curve"));
    EXPECT_EQ(active(), 3);
    EXPECT_EQ(list.currentIndex().row(), 3);
    expectOneStepOfRows("New curve", before + QStringList(QStringLiteral("Curve 4")));
}

TEST_F(CurvesPanelTest, duplicatesBehindTheActiveCurve) {
    click(button("Duplicate the curve"));
    EXPECT_EQ(active(), 1);
    expectOneStepOfRows("Duplicate the curve", {before[0], before[0], QStringLiteral("Curve 3"), before[2]});
}

TEST_F(CurvesPanelTest, deletesTheActiveCurve) {
    const Serial serial = document().serials(test::kSpline)[2];
    clickRow(2);
    click(button("Delete the curve"));
    EXPECT_EQ(active(), 1);
    expectOneStepOfRows("Delete the curve", {before[0], before[1]});
    EXPECT_EQ(document().serials(test::kSpline)[2], serial);
}

TEST_F(CurvesPanelTest, reordersAndKeepsTheActiveCurve) {
    EXPECT_FALSE(button("Move the curve up").isEnabled());
    click(button("Move the curve down"));
    EXPECT_EQ(active(), 1);
    EXPECT_EQ(list.currentIndex().row(), 1);
    expectOneStepOfRows("Reorder the curves", {QStringLiteral("Curve 1"), before[0], before[2]});
    EXPECT_EQ(active(), 0);
    clickRow(2);
    EXPECT_FALSE(button("Move the curve down").isEnabled());
    click(button("Move the curve up"));
    EXPECT_EQ(active(), 1);
    expectOneStepOfRows("Reorder the curves", {before[0], before[2], QStringLiteral("Curve 3")});
}

TEST_F(CurvesPanelTest, inAnEmptySheetOnlyAddingIsLeft) {
    editor().clear();
    EXPECT_EQ(rows(), QStringList());
    for (const char* name :
         {"Duplicate the curve", "Delete the curve", "Move the curve up", "Move the curve down", "Colour of the curve"})
        EXPECT_FALSE(button(name).isEnabled()) << name;
    click(button("New curve"));
    EXPECT_EQ(rows(), QStringList(QStringLiteral("Curve 1")));
}

} // namespace
} // namespace kriva::ui
