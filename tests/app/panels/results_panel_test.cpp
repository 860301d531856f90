#include "tests/support/panel_test.h"
#include "ui/base/examples.h"
#include "ui/controls/player.h"
#include "ui/figures/caption_text.h"
#include "ui/panels/result_text.h"
#include "ui/panels/results_panel.h"

#include <QClipboard>

namespace kriva::ui {
namespace {

using Rows = std::vector<std::pair<QString, QString>>;

class ResultsPanelTest : public test::PanelTest {
  protected:
    explicit ResultsPanelTest(SheetIndex sheet = 0)
        : PanelTest(sheet) {}
    [[nodiscard]] Rows rows() {
        test::settle();
        Rows shown;
        for (int row = 0; row < table.model()->rowCount(); ++row)
            shown.emplace_back(textAt(row, 0), textAt(row, 1));
        return shown;
    }
    [[nodiscard]] QString textAt(int row, int column) const {
        return table.model()->index(row, column).data().toString();
    }
    Rows rowsOf(const Curve& curve) {
        Rows expected;
        for (const Result& result : results(curve))
            expected.emplace_back(resultName(result), resultValue(result, 10));
        for (const Result& result : relationsOf(editor().sheetOnView(), editor().index()).results)
            expected.emplace_back(resultName(result), resultValue(result, 10));
        return expected;
    }

    ResultsPanel& table = panel<ResultsPanel>("results");
};

class ResultsInEachTab : public ResultsPanelTest, public testing::WithParamInterface<SheetIndex> {
  protected:
    ResultsInEachTab()
        : ResultsPanelTest(GetParam()) {}
};

TEST_P(ResultsInEachTab, areThoseOfTheActiveCurveAndFollowADrag) {
    const Rows before = rows();
    EXPECT_FALSE(before.empty());
    EXPECT_EQ(before, rowsOf(curve()));
    const QPoint start = test::pixelOf(tab, 1);
    QTest::mousePress(tab.canvas().viewport(), Qt::LeftButton, {}, start);
    QTest::mouseMove(tab.canvas().viewport(), start + QPoint(7, 20));
    QTest::mouseMove(tab.canvas().viewport(), start + QPoint(12, 30));
    EXPECT_NE(rows(), before);
    EXPECT_EQ(rows(), rowsOf(curve()));
    QTest::keyClick(tab.canvas().viewport(), Qt::Key_Escape);
    EXPECT_EQ(rows(), before);
}

INSTANTIATE_TEST_SUITE_P(Tabs, ResultsInEachTab, testing::Range<SheetIndex>(0, kSheetCount));

TEST_F(ResultsPanelTest, areThoseOfTheStageOnView) {
    const Rows before = rows();
    tab.findChild<Player*>()->tick();
    const Rows stage = rows();
    EXPECT_NE(stage, before);
    EXPECT_EQ(stage, rowsOf(*editor().shown(editor().activeSerial())));
    editor().setStage({});
    EXPECT_EQ(rows(), before);
}

TEST_F(ResultsPanelTest, followTheChoiceOfACurveAndOfALanguage) {
    open({curve(), ElevationCurve{"", {{0, 0}, {1, 1.5}}, 2, {}, {}}});
    document().setActiveCurve(test::kElevation, document().serials(test::kElevation)[1]);
    EXPECT_EQ(rows(), rowsOf(editor().sheet().curves[1]));
    const Rows english = rows();
    shell.language.setLanguage(Language::Slovenian);
    QApplication::processEvents();
    EXPECT_NE(rows(), english);
    EXPECT_EQ(rows(), rowsOf(editor().sheet().curves[1]));
}

TEST_F(ResultsPanelTest, areShownWithAMinusAndCopiedWithOneThatSpreadsheetsRead) {
    open({ElevationCurve{"", {{0, 0}, {-2, -1}}, 0, {}, {}}});
    const Rows shown = rows();
    const auto bounds = std::ranges::find(shown, captionText(Caption::bounds), &Rows::value_type::first);
    ASSERT_NE(bounds, shown.end());
    EXPECT_EQ(bounds->second, QStringLiteral("(−2; −1) – (0; 0)"));
    table.setCurrentIndex(table.model()->index(static_cast<int>(bounds - shown.begin()), 0));
    QTest::keySequence(&table, QKeySequence::Copy);
    EXPECT_EQ(QGuiApplication::clipboard()->text(), bounds->first + QStringLiteral("\t(-2; -1) – (0; 0)"));
}

TEST_F(ResultsPanelTest, areEmptyWithoutACurveAndSayThatOneIsIncomplete) {
    editor().clear();
    EXPECT_EQ(rows(), Rows());
    editor().addPoint({1, 2});
    EXPECT_EQ(rows().size(), 1U);
}

class SplineResultsTest : public ResultsPanelTest {
  protected:
    SplineResultsTest()
        : ResultsPanelTest(2) {
        open(exampleDocument(QStringLiteral(":/examples/self-intersections.kriva")).sheets[test::kSpline].curves);
        static_cast<void>(rows());
    }
    /// The first row of a crossing.
    [[nodiscard]] int crossingRow() {
        const Rows shown = rows();
        for (std::size_t row = 0; row < shown.size(); ++row)
            if (shown[row].first.startsWith(captionText(Caption::crossing) + QLatin1String(" 0")))
                return static_cast<int>(row);
        return -1;
    }
    void choose(int row) {
        table.scrollTo(table.model()->index(row, 0));
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                          table.visualRect(table.model()->index(row, 0)).center());
    }
};

TEST_F(SplineResultsTest, aChosenCrossingIsPointedOutAndBroughtIntoSight) {
    const std::vector<Result> ofSheet = relationsOf(editor().sheet(), test::kSpline).results;
    const auto crossing = std::ranges::find(ofSheet, Caption::crossing, &Result::caption);
    ASSERT_NE(crossing, ofSheet.end());
    const Point place = std::get<PassedPlace>(*crossing->value).at;
    Viewport elsewhere = tab.canvas().mapping();
    elsewhere.centre = place + Vector{1e3, 1e3};
    tab.canvas().setMapping(elsewhere);
    choose(crossingRow());
    EXPECT_EQ(editor().pointedOut(), Points{place});
    const Box seen = visibleBox(tab.canvas().mapping());
    EXPECT_TRUE(overlap(seen, boxOf(std::array{place})));
    EXPECT_EQ(tab.canvas().mapping().scale, elsewhere.scale);
    EXPECT_EQ(steps(), QStringList());
    table.clearSelection();
    EXPECT_EQ(editor().pointedOut(), Points());
}

TEST_F(SplineResultsTest, aCrossingNamesItsSegmentsAndParameters) {
    const PassedPlace place{{2.5, -1}, {{{}, 0, 0.25}, {{}, 12, 1.0 / 3}}};
    EXPECT_EQ(valueText(place, 10), QStringLiteral("c₀(0.25) = c₁₂(0.3333) = (2.5; −1)"));
    EXPECT_EQ(valueText(PassedPlace{{1, 1}, {{1, 0, 0.5}, {2, 3, 0}}}, 10),
              QStringLiteral("1: c₀(0.5) = 2: c₃(0) = (1; 1)"));
}

TEST_F(SplineResultsTest, theRingIsInkAroundTheCrossing) {
    tab.canvas().fitAll();
    const QImage before = tab.canvas().grab().toImage();
    choose(crossingRow());
    test::settle();
    const QImage after = tab.canvas().grab().toImage();
    const QPoint at = tab.canvas().mapping().toPixels(editor().pointedOut().at(0)).toPoint();
    int changed = 0;
    for (int y = -12; y <= 12; ++y)
        for (int x = -12; x <= 12; ++x)
            changed += before.pixel(at + QPoint(x, y)) != after.pixel(at + QPoint(x, y)) ? 1 : 0;
    EXPECT_GT(changed, 60);
}

} // namespace
} // namespace kriva::ui
