#include "tests/support/panel_test.h"
#include "ui/panels/points_panel.h"

#include <QClipboard>
#include <QSignalSpy>

namespace kriva::ui {
namespace {

using test::type;

class PointsPanelTest : public test::PanelTest {
  protected:
    explicit PointsPanelTest(SheetIndex sheet = 0)
        : PanelTest(sheet) {}
    [[nodiscard]] QPoint cell(int row, int column) {
        return table.visualRect(table.model()->index(row, column)).center();
    }
    void clickRow(int row, Qt::KeyboardModifiers keys = {}) {
        QTest::mouseClick(table.viewport(), Qt::LeftButton, keys, cell(row, 1));
    }
    /// Double-clicks a cell, types and presses Enter.
    void edit(int row, int column, const char* text) {
        test::doubleClick(*table.viewport(), cell(row, column));
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // one that refused what was typed before
        auto* field = table.viewport()->findChild<QLineEdit*>();
        ASSERT_NE(field, nullptr);
        type(*field, text);
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    void paste(const char* text) {
        QGuiApplication::clipboard()->setText(QString::fromUtf8(text));
        QTest::keyClick(&table, Qt::Key_V, Qt::ControlModifier);
    }
    [[nodiscard]] std::vector<int> markedRows() {
        std::vector<int> rows;
        for (const QModelIndex& row : table.selectionModel()->selectedRows())
            rows.push_back(row.row());
        std::ranges::sort(rows);
        return rows;
    }
    [[nodiscard]] QString text(int row, int column) { return table.model()->index(row, column).data().toString(); }

    PointsPanel& table = panel<PointsPanel>("points");
    const Curve before = curve();
};

TEST_F(PointsPanelTest, aTypedCoordinateArrivesBitForBitAndChangesNoOther) {
    for (const char* number : {"0,1", "0.1"}) {
        auto after = std::get<ElevationCurve>(before);
        after.points[2].x = 0.1;
        edit(2, PointsModel::kX, number);
        expectOneStep("Move point 2", before, after);
        EXPECT_EQ(text(2, PointsModel::kX), QStringLiteral("6"));
    }
    auto after = std::get<ElevationCurve>(before);
    after.points[1].y = -0.5;
    edit(1, PointsModel::kY, "-0,5");
    expectOneStep("Move point 1", before, after);
}

TEST_F(PointsPanelTest, refusedNumbersChangeNothing) {
    for (const char* number : {"1.234,5", "2e9", "", "nan", "6"}) // the last is the number that is there
        edit(2, PointsModel::kX, number);
    expectNoStep(before);
}

TEST_F(PointsPanelTest, theSelectionGoesBothWays) {
    clickRow(1);
    EXPECT_EQ(editor().selectedPoints(), std::vector<int>{1});
    clickRow(3, Qt::ShiftModifier);
    EXPECT_EQ(editor().selectedPoints(), (std::vector<int>{1, 2, 3}));
    clickRow(2, Qt::ControlModifier);
    EXPECT_EQ(editor().selectedPoints(), (std::vector<int>{1, 3}));
    QTest::mouseClick(tab.canvas().viewport(), Qt::LeftButton, {}, test::pixelOf(tab, 0));
    EXPECT_EQ(markedRows(), std::vector<int>{0});
    editor().selectAll();
    EXPECT_EQ(markedRows(), (std::vector<int>{0, 1, 2, 3}));
    editor().selectNone();
    EXPECT_EQ(markedRows(), std::vector<int>{});
    expectNoStep(before);
}

TEST_F(PointsPanelTest, neighboursAreOneRangeBothWays) {
    ElevationCurve many;
    for (int i = 0; i < 100; ++i)
        many.points.push_back({i / 8.0, 0});
    open({many});
    editor().selectAll();
    EXPECT_EQ(table.selectionModel()->selection().size(), 1);
    selectPoints({0, 1, 2, 50, 51, 99});
    EXPECT_EQ(table.selectionModel()->selection().size(), 3);
    EXPECT_EQ(markedRows(), (std::vector<int>{0, 1, 2, 50, 51, 99}));
    clickRow(0);
    clickRow(4, Qt::ShiftModifier);
    EXPECT_EQ(table.selectionModel()->selection().size(), 1);
    EXPECT_EQ(editor().selectedPoints(), (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST_F(PointsPanelTest, marksNoRowForThePointsOfAnotherCurve) {
    open({before, ElevationCurve{"", {{0, 0}, {1, 1}}, 0, {}, {}}});
    selectPoints({1, 3});
    document().setActiveCurve(test::kElevation, document().serials(test::kElevation)[1]);
    EXPECT_EQ(markedRows(), editor().selectedPoints());
    EXPECT_EQ(markedRows(), std::vector<int>{});
    QTest::keyClick(&table, Qt::Key_Delete);
    EXPECT_EQ(pointCount(curve()), 2U);
    document().setActiveCurve(test::kElevation, document().serials(test::kElevation)[0]);
    EXPECT_EQ(markedRows(), editor().selectedPoints());
}

TEST_F(PointsPanelTest, deleteRemovesTheSelectedRowsInOneStep) {
    auto after = std::get<ElevationCurve>(before);
    after.points = {after.points[0], after.points[2]};
    clickRow(1);
    clickRow(3, Qt::ControlModifier);
    QTest::keyClick(&table, Qt::Key_Delete);
    EXPECT_EQ(table.model()->rowCount(), 2 + 1);
    EXPECT_EQ(markedRows(), std::vector<int>{});
    expectOneStep("Remove points", before, after);
    EXPECT_EQ(table.model()->rowCount(), 4 + 1);
    clickRow(3);
    QTest::keyClick(&table, Qt::Key_Backspace);
    EXPECT_EQ(steps(), QStringList(QStringLiteral("Remove point 3")));
}

TEST_F(PointsPanelTest, aPastedTableIsOneStep) {
    auto after = std::get<ElevationCurve>(before);
    after.points.insert(after.points.end(), {{0.5, 1}, {2, -0.25}});
    for (const char* lines : {"0,5\t1\n2\t-0,25\n", "0.5; 1\n2; -0.25", "0.5,1\r\n2,-0.25\r\n"}) {
        paste(lines);
        EXPECT_EQ(text(5, PointsModel::kY), QStringLiteral("−0.25"));
        expectOneStep("Paste points", before, after);
    }
}

TEST_F(PointsPanelTest, aTablePastedIntoAnEmptySheetIsOneStep) {
    open({});
    paste("1\t2\n3\t4");
    EXPECT_EQ(steps(), QStringList(QStringLiteral("Paste points")));
    EXPECT_EQ(value<ElevationCurve>().points, (Points{{1, 2}, {3, 4}}));
    EXPECT_EQ(markedRows(), (std::vector<int>{0, 1}));
    document().undo();
    EXPECT_EQ(editor().activeCurve(), nullptr);
}

TEST_F(PointsPanelTest, aRefusedPasteChangesNothing) {
    for (const char* lines : {"", "hello", "1\t2\t3", "1\t2\nthree\t4", "2e9\t0"})
        paste(lines);
    expectNoStep(before);
}

TEST_F(PointsPanelTest, f2EditsItsCellAndNotTheNameOfTheCurve) {
    clickRow(1);
    QTest::keyClick(&table, Qt::Key_F2);
    EXPECT_NE(table.viewport()->findChild<QLineEdit*>(), nullptr);
}

TEST_F(PointsPanelTest, moreThanTheCurveHasRoomForIsRefused) {
    const QSignalSpy refusals(&document(), &OpenDocument::refused);
    paste(QByteArray("1\t2\n").repeated(198).constData()); // with the four there are, one more than 201
    EXPECT_EQ(refusals.count(), 1);
    expectNoStep(before);
    EXPECT_EQ(table.model()->rowCount(), 4 + 1);
}

TEST_F(PointsPanelTest, copiesTheSelectedRowsAsATable) {
    clickRow(0);
    clickRow(3, Qt::ControlModifier);
    QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QGuiApplication::clipboard()->text(), QStringLiteral("0\t0\n8\t1"));
}

class MultiplicityColumnTest : public PointsPanelTest {
  protected:
    MultiplicityColumnTest()
        : PointsPanelTest(1) {}
};

TEST_F(MultiplicityColumnTest, setsTheMultiplicityOfItsPoint) {
    auto after = std::get<SubdivisionCurve>(before);
    after.multiplicity = {1, 1, 3, 1};
    edit(2, 2, "3");
    EXPECT_EQ(text(2, 2), QStringLiteral("3"));
    expectOneStep("Set the multiplicity", before, after);
    for (const char* refused : {"0", "1,5", "199", "twice"})
        edit(2, 2, refused);
    expectNoStep(before);
}

class JoinColumnTest : public PointsPanelTest {
  protected:
    JoinColumnTest()
        : PointsPanelTest(2) {}
};

TEST_F(JoinColumnTest, setsTheJoinOfItsKnotInTheWordsOfTheLanguage) {
    edit(1, 2, "corner");
    EXPECT_EQ(text(1, 2), QStringLiteral("Corner"));
    EXPECT_EQ(value<SplineCurve>().knots[1].join, SplineKnot::Join::corner);
    EXPECT_EQ(steps(), QStringList(QStringLiteral("Set the join")));
    document().undo();
    edit(1, 2, "soft");
    expectNoStep(before);
    shell.language.setLanguage(Language::Slovenian);
    QApplication::processEvents();
    EXPECT_NE(text(1, 2), QStringLiteral("Automatic"));
    edit(2, 2, "corner");
    expectNoStep(before);
}

TEST_F(PointsPanelTest, tellsAllRowsOfAnotherCurveWithTheSamePoints) {
    open({before, before});
    const QSignalSpy changes(table.model(), &QAbstractItemModel::dataChanged);
    document().setActiveCurve(sheet_, document().serials(sheet_)[1]);
    ASSERT_FALSE(changes.isEmpty());
    EXPECT_EQ(changes[0][0].toModelIndex().row(), 0);
    EXPECT_EQ(changes[0][1].toModelIndex().row(), table.model()->rowCount() - 1);
}

} // namespace
} // namespace kriva::ui
