#include "tests/support/panel_test.h"
#include "ui/panels/history_panel.h"

namespace kriva::ui {
namespace {

class HistoryPanelTest : public test::PanelTest {
  protected:
    HistoryPanelTest()
        : PanelTest(test::kElevation) {
        values.push_back(curve());
        editor().addPoint({9, 0});
        values.push_back(curve());
        editor().placePoint(2, {5, 5});
        values.push_back(curve());
        editor().reverse();
        values.push_back(curve());
    }
    [[nodiscard]] QStringList rows() {
        QStringList texts;
        for (int row = 0; row < history.count(); ++row)
            texts.append(history.item(row)->text());
        return texts;
    }
    void clickRow(int row) {
        const QRect at = history.visualItemRect(history.item(row));
        QTest::mouseClick(history.viewport(), Qt::LeftButton, {}, at.center());
    }

    HistoryPanel& history = panel<HistoryPanel>("history");
    std::vector<Curve> values; ///< after each number of steps
};

TEST_F(HistoryPanelTest, aClickGoesToTheStep) {
    EXPECT_EQ(rows(), QStringList({QStringLiteral("Beginning"), QStringLiteral("Add a point"),
                                   QStringLiteral("Move point 2"), QStringLiteral("Reverse the curve")}));
    for (const int row : {1, 0, 3, 2}) {
        clickRow(row);
        EXPECT_TRUE(curve() == values[static_cast<std::size_t>(row)]) << row;
        EXPECT_EQ(history.currentRow(), row);
        EXPECT_EQ(document().isModified(), row != 0);
    }
    EXPECT_EQ(history.count(), 4);
}

TEST_F(HistoryPanelTest, followsUndoAndDropsWhatANewStepReplaces) {
    document().undo();
    document().undo();
    EXPECT_EQ(history.currentRow(), 1);
    EXPECT_EQ(history.count(), 4);
    editor().removeLastPoint();
    EXPECT_EQ(history.count(), 3);
    EXPECT_EQ(history.currentRow(), 2);
    shell.window.session().show({});
    EXPECT_EQ(rows(), QStringList(QStringLiteral("Beginning")));
}

TEST_F(HistoryPanelTest, itsWordsFollowTheLanguage) {
    const QStringList english = rows();
    shell.language.setLanguage(Language::Bulgarian);
    QApplication::processEvents();
    const QStringList bulgarian = rows();
    ASSERT_EQ(bulgarian.size(), english.size());
    for (qsizetype i = 0; i < english.size(); ++i)
        EXPECT_NE(bulgarian[i], english[i]);
    EXPECT_TRUE(bulgarian[2].contains(QLatin1Char('2')));
    shell.language.setLanguage(Language::English);
    QApplication::processEvents();
    EXPECT_EQ(rows(), english);
}

} // namespace
} // namespace kriva::ui
