#include "core/io/tables/table_writer.h"
#include "tests/support/panel_test.h"
#include "ui/figures/caption_text.h"
#include "ui/panels/results_panel.h"
#include "ui/panels/tables/tables_panel.h"

#include <QClipboard>

namespace kriva::ui {
namespace {

class TablesPanelTest : public test::PanelTest {
  protected:
    explicit TablesPanelTest(SheetIndex sheet = 1)
        : PanelTest(sheet) {
        test::settle();
    }
    [[nodiscard]] const Table& shown() {
        test::settle();
        return static_cast<TableModel*>(panel_.findChild<QTableView*>()->model())->table();
    }
    [[nodiscard]] QString textAt(int row, int column) {
        return panel_.findChild<QTableView*>()->model()->index(row, column).data().toString();
    }
    [[nodiscard]] QPoint pixelOf(Point place) { return tab.canvas().mapping().toPixels(place).toPoint(); }
    void clickCanvas(Point place) {
        QTest::mouseClick(tab.canvas().viewport(), Qt::LeftButton, {}, pixelOf(place));
        test::settle();
    }
    void choose(int table) { panel_.findChild<QComboBox*>()->setCurrentIndex(table); }

    TablesPanel& panel_ = panel<TablesPanel>("tables");
};

class TablesInEachTab : public TablesPanelTest, public testing::WithParamInterface<SheetIndex> {
  protected:
    TablesInEachTab()
        : TablesPanelTest(GetParam()) {}
    [[nodiscard]] std::vector<Table> tablesNow() {
        return withoutLimit([this](WorkBudget& budget) { return shell.sheets[sheet_].tables(curve(), budget); });
    }
};

TEST_P(TablesInEachTab, areThoseOfTheActiveCurveAndFollowADrag) {
    const std::vector<Table> before = tablesNow();
    ASSERT_FALSE(before.empty());
    for (std::size_t i = 0; i < before.size(); ++i) {
        choose(static_cast<int>(i));
        EXPECT_EQ(shown(), before[i]);
    }
    QTest::mousePress(tab.canvas().viewport(), Qt::LeftButton, {}, test::pixelOf(tab, 1));
    QTest::mouseMove(tab.canvas().viewport(), test::pixelOf(tab, 1) + QPoint(9, 31));
    QTest::mouseRelease(tab.canvas().viewport(), Qt::LeftButton, {}, test::pixelOf(tab, 1));
    EXPECT_EQ(shown(), tablesNow().back());
    EXPECT_NE(shown(), before.back());
}

INSTANTIATE_TEST_SUITE_P(Tabs, TablesInEachTab, testing::Range<SheetIndex>(0, kSheetCount));

TEST_F(TablesPanelTest, showTheExampleOfTheSources) {
    SubdivisionCurve cubic;
    cubic.points = {{0, 0}, {0, 2}, {8, 2}, {4, 0}};
    cubic.multiplicity.assign(4, 1);
    open({cubic});
    EXPECT_EQ(shown().caption, Caption::construction);
    EXPECT_EQ(textAt(0, 4), QStringLiteral("(3.5; 1.5)"));
    EXPECT_EQ(textAt(1, 2), QStringLiteral("(4; 2)"));
    EXPECT_EQ(textAt(1, 4), QString());
}

TEST_F(TablesPanelTest, chooseThePointOfTheConstructionThatIsClicked) {
    SubdivisionCurve cubic;
    cubic.points = {{0, 0}, {0, 2}, {8, 2}, {4, 0}};
    cubic.multiplicity.assign(4, 1);
    open({cubic});
    static_cast<void>(panel<ResultsPanel>("results"));
    clickCanvas({4, 2});
    EXPECT_EQ(shown().caption, Caption::construction);
    EXPECT_EQ(panel_.findChild<QTableView*>()->currentIndex().data().toString(), QStringLiteral("(4; 2)"));
    choose(2);
    clickCanvas({3.5, 1.5});
    EXPECT_EQ(shown().caption, Caption::leftAndRight) << "the table on view has it too";
    EXPECT_EQ(editor().pointedOut(), (Points{{3.5, 1.5}}));
    clickCanvas({4, 2});
    EXPECT_EQ(shown().caption, Caption::construction);
}

TEST_F(TablesPanelTest, areCopiedAsLatexAndForSpreadsheets) {
    const Table table = shown();
    test::click(test::named<QToolButton>(panel_, "Copy the table as LaTeX"));
    EXPECT_EQ(QGuiApplication::clipboard()->text().toStdString(), writeLatex(table, textSource()));
    test::click(test::named<QToolButton>(panel_, "Copy the table for a spreadsheet"));
    EXPECT_EQ(QGuiApplication::clipboard()->text().toStdString(), writeDelimited(table, textSource()));
    EXPECT_EQ(steps(), QStringList());
}

TEST_F(TablesPanelTest, keepTheChosenOneAndFollowTheLanguage) {
    choose(1);
    const Table weights = shown();
    shell.language.setLanguage(Language::Ukrainian);
    test::settle();
    EXPECT_EQ(shown(), weights);
    EXPECT_EQ(panel_.findChild<QComboBox*>()->currentIndex(), 1);
    EXPECT_EQ(panel_.findChild<QComboBox*>()->currentText(), captionText(Caption::weightsAtT));
}

class ElevationTablesTest : public TablesPanelTest {
  protected:
    ElevationTablesTest()
        : TablesPanelTest(0) {
        open({ElevationCurve{"", {{0, 0}, {0, 3}, {9, 3}, {3, 0}}, 1, {}, {}}});
        static_cast<void>(shown());
    }
    void choose(int row, int column) {
        auto* view = panel_.findChild<QTableView*>();
        QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
                          view->visualRect(view->model()->index(row, column)).center());
    }
    [[nodiscard]] QString sum() { return panel_.findChild<QLabel*>(QStringLiteral("sum"))->text(); }
};

TEST_F(ElevationTablesTest, tellHowTheChosenPointIsWorkedOutAndPointItOut) {
    choose(1, 5);
    EXPECT_EQ(sum(), QStringLiteral("b′₁ = 0.25 · (0; 0) + 0.75 · (0; 3) = (0; 2.25)"));
    EXPECT_EQ(editor().pointedOut(), (Points{{0, 2.25}}));
    choose(0, 5);
    EXPECT_EQ(sum(), QStringLiteral("b′₀ = 1 · (0; 0) = (0; 0)"));
    editor().placePoint(0, {4, 4});
    static_cast<void>(shown());
    EXPECT_EQ(sum(), QStringLiteral("b′₀ = 1 · (4; 4) = (4; 4)"));
    EXPECT_EQ(editor().pointedOut(), (Points{{4, 4}})) << "it moved with the point";
    choose(0, 0);
    EXPECT_EQ(editor().pointedOut(), Points()) << "a number is nowhere";
}

TEST_F(ElevationTablesTest, pointNothingOutBehindAnotherPanel) {
    choose(1, 5);
    static_cast<void>(panel<ResultsPanel>("results"));
    EXPECT_EQ(editor().pointedOut(), Points());
    static_cast<void>(panel<TablesPanel>("tables"));
    EXPECT_EQ(editor().pointedOut(), (Points{{0, 2.25}}));
}

TEST_F(ElevationTablesTest, comeToTheFrontForAnElevatedPointThatIsClicked) {
    static_cast<void>(panel<ResultsPanel>("results"));
    QTest::mouseMove(tab.canvas().viewport(), pixelOf({0, 2.25}));
    EXPECT_EQ(shell.window.findChild<QLabel*>(QStringLiteral("hint"))->text(),
              QStringLiteral("Click: how this point is worked out, in Tables"));
    clickCanvas({0, 2.25});
    EXPECT_TRUE(panel_.isVisible());
    EXPECT_EQ(sum(), QStringLiteral("b′₁ = 0.25 · (0; 0) + 0.75 · (0; 3) = (0; 2.25)"));
    EXPECT_EQ(editor().pointedOut(), (Points{{0, 2.25}}));
    clickCanvas({7.5, 2.25});
    EXPECT_EQ(sum().left(3), QStringLiteral("b′₃"));
    EXPECT_EQ(steps(), QStringList());
}

TEST_F(ElevationTablesTest, haveIndicesBelowTheLetters) {
    const QAbstractItemModel& model = *panel_.findChild<QTableView*>()->model();
    EXPECT_EQ(model.headerData(2, Qt::Horizontal).toString(), QStringLiteral("bᵢ₋₁"));
    EXPECT_EQ(model.headerData(5, Qt::Horizontal).toString(), QStringLiteral("b′ᵢ"));
}

} // namespace
} // namespace kriva::ui
