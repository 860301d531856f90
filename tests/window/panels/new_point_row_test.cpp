#include "tests/support/panel_test.h"
#include "ui/panels/points_panel.h"

#include <QAccessible>
#include <QClipboard>
#include <QSignalSpy>

namespace kriva::ui {
namespace {

/// The empty last row of the Points table, with the keyboard alone.
class NewPointRow : public test::PanelTest {
  protected:
    explicit NewPointRow(SheetIndex sheet = 0)
        : PanelTest(sheet) {
        table.setFocus();
    }
    /// As the keyboard does: to whatever has the focus now.
    void press(Qt::Key key, Qt::KeyboardModifiers keys = {}) {
        QTest::keyClick(QApplication::focusWidget(), key, keys);
        turn();
    }
    void type(const char* text) {
        for (const QChar letter : QString::fromUtf8(text)) {
            QTest::keyClicks(QApplication::focusWidget(), letter);
            turn();
        }
    }
    static void turn() {
        QApplication::processEvents();
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    void clickBlankSpace() {
        const QPoint below(table.viewport()->width() / 2, table.viewport()->height() - 3);
        ASSERT_FALSE(table.indexAt(below).isValid());
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, below);
    }
    void clickRow(int row, Qt::KeyboardModifiers keys = {}) {
        QTest::mouseClick(table.viewport(), Qt::LeftButton, keys,
                          table.visualRect(table.model()->index(row, PointsModel::kY)).center());
    }
    [[nodiscard]] int newRow() { return table.model()->rowCount() - 1; }
    [[nodiscard]] QString text(int row, int column) { return table.model()->index(row, column).data().toString(); }
    [[nodiscard]] bool isOpen() { return table.viewport()->findChild<QLineEdit*>() != nullptr; }
    void expectAdded(Point at) {
        EXPECT_TRUE(curve() == withPointAdded(before, at).curve);
        EXPECT_EQ(steps(), QStringList(QStringLiteral("Add a point")));
        document().undo();
        EXPECT_TRUE(curve() == before);
    }

    PointsPanel& table = panel<PointsPanel>("points");
    const Curve before = curve();
};

TEST_F(NewPointRow, isTheLastOneEmptyAndNeverSelected) {
    EXPECT_EQ(table.model()->rowCount(), 5);
    EXPECT_EQ(text(4, 0), QString());
    EXPECT_EQ(text(4, 1), QString());
    clickRow(4);
    EXPECT_TRUE(editor().selectedPoints().empty());
    EXPECT_EQ(table.currentIndex().row(), 4);
    expectNoStep(before);
}

TEST_F(NewPointRow, whatIsTypedAfterAClickIntoBlankSpaceChangesNoRowAndLosesNoKey) {
    clickRow(0);
    clickBlankSpace();
    type("1,5");
    press(Qt::Key_Return);
    expectNoStep(before);
    EXPECT_EQ(text(4, PointsModel::kX), QStringLiteral("1.5"));
    type("-2");
    press(Qt::Key_Return);
    expectAdded({1.5, -2});
}

TEST_F(NewPointRow, takesXThenTabThenY) {
    clickBlankSpace();
    type("0.25");
    press(Qt::Key_Tab);
    EXPECT_TRUE(isOpen());
    type("3");
    press(Qt::Key_Return);
    EXPECT_EQ(text(4, PointsModel::kX), QStringLiteral("0.25"));
    EXPECT_EQ(text(5, PointsModel::kX), QString());
    EXPECT_EQ(table.currentIndex().row(), 5) << "the next point";
    EXPECT_EQ(table.currentIndex().column(), PointsModel::kX);
    EXPECT_EQ(editor().selectedPoints(), std::vector<int>{4});
    expectAdded({0.25, 3});
}

TEST_F(NewPointRow, manyPointsAreTypedOneAfterTheOther) {
    clickBlankSpace();
    for (const char* number : {"1", "2", "3", "4"}) {
        type(number);
        press(Qt::Key_Tab);
    }
    EXPECT_EQ(steps().size(), 2);
    EXPECT_EQ(pointAt(curve(), 4), (Point{1, 2}));
    EXPECT_EQ(pointAt(curve(), 5), (Point{3, 4}));
}

TEST_F(NewPointRow, noughtIsANumberLikeAnyOther) {
    clickBlankSpace();
    type("0");
    press(Qt::Key_Tab);
    type("0");
    press(Qt::Key_Return);
    expectAdded({0, 0});
}

TEST_F(NewPointRow, keepsOneCoordinateUntilTheOtherIsThere) {
    clickBlankSpace();
    type("7");
    clickRow(1);
    turn();
    expectNoStep(before);
    EXPECT_EQ(text(4, PointsModel::kX), QStringLiteral("7"));
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                      table.visualRect(table.model()->index(4, PointsModel::kY)).center());
    type("8");
    press(Qt::Key_Return);
    expectAdded({7, 8});
}

TEST_F(NewPointRow, deleteClearsWhatItKeepsAndRemovesNoPoint) {
    clickBlankSpace();
    type("7");
    press(Qt::Key_Return);
    press(Qt::Key_Delete);
    EXPECT_EQ(text(4, PointsModel::kX), QString());
    expectNoStep(before);
}

TEST_F(NewPointRow, isLeftAloneByKeysThatWalkThroughIt) {
    clickRow(3);
    press(Qt::Key_Down);
    EXPECT_EQ(table.currentIndex().row(), 4);
    EXPECT_TRUE(editor().selectedPoints().empty());
    press(Qt::Key_F2);
    press(Qt::Key_Tab); // nothing typed
    EXPECT_EQ(table.currentIndex().row(), 4) << "and not in the first row";
    press(Qt::Key_Escape);
    press(Qt::Key_Up);
    EXPECT_EQ(table.currentIndex().row(), 3);
    expectNoStep(before);
    EXPECT_EQ(text(4, PointsModel::kX), QString());
}

TEST_F(NewPointRow, takesYBeforeX) {
    clickRow(3);
    press(Qt::Key_Down);
    type("5");
    press(Qt::Key_Tab);
    type("6");
    press(Qt::Key_Tab);
    expectAdded({6, 5});
}

TEST_F(NewPointRow, typingWithRowsSelectedEditsTheCurrentCellOfTheirs) {
    clickRow(1);
    clickRow(2, Qt::ShiftModifier);
    type("9");
    press(Qt::Key_Return);
    auto after = std::get<ElevationCurve>(before);
    after.points[2].y = 9;
    expectOneStep("Move point 2", before, after);
}

TEST_F(NewPointRow, aCurrentRowThatIsNotSelectedIsNotEdited) {
    clickRow(1);
    editor().selectNone();
    type("4");
    press(Qt::Key_Return);
    expectNoStep(before);
    EXPECT_EQ(text(4, PointsModel::kX), QStringLiteral("4"));
    clickRow(1);
    QTest::mouseClick(table.viewport(), Qt::LeftButton, Qt::ControlModifier,
                      table.visualRect(table.model()->index(1, 0)).center());
    press(Qt::Key_F2);
    EXPECT_EQ(table.currentIndex().row(), 4);
}

TEST_F(NewPointRow, typingEditsThePointThatWasSelectedOnTheCanvas) {
    clickRow(0);
    selectPoints({2});
    type("9");
    press(Qt::Key_Return);
    auto after = std::get<ElevationCurve>(before);
    after.points[2].y = 9;
    expectOneStep("Move point 2", before, after);
}

TEST_F(NewPointRow, lettersDoNotSearchAndAreRefusedInPlace) {
    table.setCurrentIndex({});
    type("0");
    EXPECT_EQ(table.currentIndex().row(), 4);
    press(Qt::Key_Escape);
    type("x");
    press(Qt::Key_Return);
    ASSERT_TRUE(isOpen()) << "a refused text stays, with the reason";
    EXPECT_FALSE(table.viewport()->findChild<QLineEdit*>()->accessibleDescription().isEmpty());
    press(Qt::Key_Tab);
    EXPECT_TRUE(isOpen());
    clickRow(1);
    turn();
    EXPECT_FALSE(isOpen());
    EXPECT_EQ(text(4, 0), QString());
    expectNoStep(before);
}

TEST_F(NewPointRow, afterUndoWhatIsTypedComesToTheNewRow) {
    clickBlankSpace();
    type("1");
    press(Qt::Key_Tab);
    type("2");
    press(Qt::Key_Return);
    document().undo();
    EXPECT_EQ(table.model()->rowCount(), 5);
    type("3");
    press(Qt::Key_Tab);
    type("4");
    press(Qt::Key_Return);
    expectAdded({3, 4});
}

TEST_F(NewPointRow, aPointThatComesFromElsewhereLeavesTheOneBeingTyped) {
    clickBlankSpace();
    type("6");
    editor().addPoint({11, 12});
    press(Qt::Key_Return);
    EXPECT_EQ(pointAt(curve(), 4), (Point{11, 12}));
    EXPECT_EQ(text(5, PointsModel::kX), QStringLiteral("6"));
}

TEST_F(NewPointRow, makesACurveInAnEmptySheet) {
    open({});
    table.setFocus();
    EXPECT_EQ(table.model()->rowCount(), 1);
    type("1");
    press(Qt::Key_Tab);
    EXPECT_EQ(editor().activeCurve(), nullptr);
    type("2");
    press(Qt::Key_Return);
    ASSERT_NE(editor().activeCurve(), nullptr);
    EXPECT_EQ(value<ElevationCurve>().points, Points{Point(1, 2)});
    EXPECT_EQ(steps(), QStringList(QStringLiteral("Add a point")));
    type("3");
    press(Qt::Key_Tab);
    type("4");
    press(Qt::Key_Return);
    EXPECT_EQ(value<ElevationCurve>().points, (Points{{1, 2}, {3, 4}}));
    document().undo();
    document().undo();
    EXPECT_EQ(editor().activeCurve(), nullptr);
}

TEST_F(NewPointRow, keepsBothCoordinatesWhereTheSheetIsFull) {
    ElevationCurve full;
    for (int i = 0; i < 201; ++i)
        full.points.push_back({i / 10.0, 0});
    open({full});
    table.setFocus();
    const QSignalSpy refusals(&document(), &OpenDocument::refused);
    type("1");
    press(Qt::Key_Tab);
    type("2");
    press(Qt::Key_Return);
    EXPECT_EQ(refusals.count(), 1);
    expectNoStep(full);
    EXPECT_EQ(text(201, PointsModel::kX), QStringLiteral("1"));
    EXPECT_EQ(text(201, PointsModel::kY), QStringLiteral("2"));
}

TEST_F(NewPointRow, whatWasBegunForACurveIsNoPointOfAnotherOne) {
    open({before, before});
    table.setFocus();
    clickRow(1);
    type("5");
    document().setActiveCurve(test::kElevation, document().serials(test::kElevation)[1]);
    turn();
    EXPECT_FALSE(isOpen());
    EXPECT_TRUE(curve() == before);
    EXPECT_EQ(steps(), QStringList());
}

TEST_F(NewPointRow, isNamedToScreenReadersInTheLanguage) {
    const QModelIndex cell = table.model()->index(4, 0);
    EXPECT_EQ(cell.data(Qt::AccessibleTextRole).toString(), QStringLiteral("New point"));
    QAccessibleInterface* rows = QAccessible::queryAccessibleInterface(&table);
    QAccessibleTableInterface* asTable = rows->tableInterface();
    ASSERT_NE(asTable, nullptr);
    EXPECT_EQ(asTable->cellAt(4, 0)->text(QAccessible::Name), QStringLiteral("New point"));
    type("5");
    EXPECT_EQ(QApplication::focusWidget()->accessibleName(), QStringLiteral("New point"));
    press(Qt::Key_Return);
    shell.language.setLanguage(Language::Slovenian);
    turn();
    EXPECT_NE(cell.data(Qt::AccessibleTextRole).toString(), QStringLiteral("New point"));
    EXPECT_EQ(text(4, 0), QStringLiteral("5")) << "and keeps what it kept";
    type("0,5");
    press(Qt::Key_Return);
    EXPECT_EQ(pointAt(curve(), 4), (Point{5, 0.5}));
}

TEST_F(NewPointRow, aPastedTableIsNotForOneCell) {
    QGuiApplication::clipboard()->setText(QStringLiteral("1\t2\n3\t4"));
    clickBlankSpace();
    press(Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(steps(), QStringList(QStringLiteral("Paste points")));
    EXPECT_EQ(pointCount(curve()), 6u);
    document().undo();
    clickBlankSpace();
    press(Qt::Key_F2);
    ASSERT_TRUE(isOpen());
    press(Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(pointCount(curve()), 6u);
}

class NewPointWithMultiplicity : public NewPointRow {
  protected:
    NewPointWithMultiplicity()
        : NewPointRow(1) {}
};

TEST_F(NewPointWithMultiplicity, standsOnceAndItsMultiplicityComesNext) {
    clickBlankSpace();
    EXPECT_FALSE(table.model()->index(newRow(), 2).flags().testFlag(Qt::ItemIsEditable)) << "of no point yet";
    type("1");
    press(Qt::Key_Tab);
    type("2");
    press(Qt::Key_Tab);
    EXPECT_EQ(text(4, 2), QStringLiteral("1"));
    ASSERT_TRUE(isOpen());
    type("0");
    press(Qt::Key_Return);
    ASSERT_TRUE(isOpen()) << "refused in place";
    EXPECT_TRUE(QApplication::focusWidget()->accessibleDescription().contains(QStringLiteral("197")));
    press(Qt::Key_Backspace);
    type("3");
    press(Qt::Key_Return);
    EXPECT_EQ(value<SubdivisionCurve>().multiplicity, (std::vector<int>{1, 1, 1, 1, 3}));
    EXPECT_EQ(steps(), (QStringList{QStringLiteral("Add a point"), QStringLiteral("Set the multiplicity")}));
}

class NewPointInEachTab : public NewPointRow, public testing::WithParamInterface<SheetIndex> {
  protected:
    NewPointInEachTab()
        : NewPointRow(GetParam()) {}
};

TEST_P(NewPointInEachTab, isOneStep) {
    editor().selectNone(); // some tables are longer than their panel
    type("2,5");
    press(Qt::Key_Tab);
    type("-1e-3");
    press(Qt::Key_Enter);
    expectAdded({2.5, -1e-3});
}

INSTANTIATE_TEST_SUITE_P(InEachTab, NewPointInEachTab, testing::Range<SheetIndex>(0, kSheetCount));

} // namespace
} // namespace kriva::ui
