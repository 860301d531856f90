#include "tests/support/answers.h"
#include "tests/support/panel_test.h"
#include "ui/panels/points_panel.h"

#include <QLineEdit>
#include <QTemporaryDir>

namespace kriva::ui {
namespace {

using test::answerWith;

/// What still stands in a field or a cell when the document is saved or given up.
class Typing : public test::PanelTest {
  protected:
    Typing()
        : PanelTest(test::kElevation) {
        table.setFocus();
        editor().selectNone(); // what is typed comes to the new row
    }
    /// To whatever has the focus now.
    static void type(const char* text) {
        for (const QChar letter : QString::fromUtf8(text)) {
            if (letter == u'\t')
                QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            else
                QTest::keyClicks(QApplication::focusWidget(), letter);
            QApplication::processEvents();
            QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        }
    }
    [[nodiscard]] DocumentSession& session() { return shell.window.session(); }
    [[nodiscard]] Curve saved() const {
        return std::get<LoadedFile>(loadDocument(file)).document.sheets[test::kElevation].curves.at(0);
    }
    [[nodiscard]] bool isOpen() { return table.viewport()->findChild<QLineEdit*>() != nullptr; }
    [[nodiscard]] Curve withPoint(Point at) const { return withPointAdded(before, at).curve; }

    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("a.kriva"));
    PointsPanel& table = panel<PointsPanel>("points");
    const Curve before = curve();
};

TEST_F(Typing, aPointIsSavedWithTheCoordinateThatStandsInItsCell) {
    type("1,5\t-2");
    ASSERT_TRUE(session().saveTo(file));
    EXPECT_TRUE(saved() == withPoint({1.5, -2}));
    EXPECT_TRUE(isOpen()) << "nobody has left it";
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    EXPECT_FALSE(shell.window.isWindowModified());
    expectOneStep("Add a point", before, withPoint({1.5, -2}));
}

TEST_F(Typing, aCoordinateIsSavedAsItStandsInItsCell) {
    auto after = std::get<ElevationCurve>(before);
    after.points[1].x = 0.5;
    table.setCurrentIndex(table.model()->index(1, PointsModel::kX));
    table.edit(table.currentIndex());
    type("0.5");
    ASSERT_TRUE(session().saveTo(file));
    EXPECT_TRUE(saved() == Curve(after));
}

TEST_F(Typing, theWindowIsNotClosedUnaskedOverAPointInItsCell) {
    type("1\t2");
    answerWith(QMessageBox::Cancel);
    EXPECT_FALSE(shell.window.close());
    EXPECT_TRUE(curve() == withPoint({1, 2}));
}

TEST_F(Typing, anotherDocumentIsNotOpenedUnaskedOverAPointInItsCell) {
    type("1\t2");
    answerWith(QMessageBox::Cancel);
    session().newDocument();
    EXPECT_TRUE(curve() == withPoint({1, 2}));
}

TEST_F(Typing, aPointInItsCellStaysWhereAnotherTabIsShown) {
    type("1\t2");
    document().setActiveSheet(test::kSubdivision);
    QApplication::processEvents();
    document().setActiveSheet(test::kElevation);
    EXPECT_TRUE(curve() == withPoint({1, 2}));
}

TEST_F(Typing, aPointInItsCellIsKeptWhereTheProgramIsEnded) {
    type("1\t2");
    session().keepForNextStart();
    EXPECT_TRUE(curve() == withPoint({1, 2}));
}

TEST_F(Typing, halfAPointStaysInItsRow) {
    type("7");
    ASSERT_TRUE(session().saveTo(file));
    EXPECT_TRUE(saved() == before);
    EXPECT_EQ(table.model()->index(4, PointsModel::kX).data().toString(), QStringLiteral("7"));
}

TEST_F(Typing, whatACellRefusesStaysInItAndChangesNothing) {
    type("1\tx");
    ASSERT_TRUE(session().saveTo(file));
    EXPECT_TRUE(saved() == before);
    ASSERT_TRUE(isOpen());
    EXPECT_EQ(table.viewport()->findChild<QLineEdit*>()->text(), QStringLiteral("x"));
}

TEST_F(Typing, theNameOfACurveIsSavedAsItStandsInTheList) {
    tab.panels().beginRenaming();
    type("arch");
    ASSERT_TRUE(session().saveTo(file));
    EXPECT_EQ(nameOf(saved()), "arch");
}

TEST_F(Typing, aNumberInAPanelThatFloatsIsSavedToo) {
    auto* dock = tab.findChild<QDockWidget*>(QStringLiteral("points"));
    dock->setFloating(true);
    QApplication::processEvents();
    dock->activateWindow();
    QApplication::processEvents();
    table.setFocus();
    type("3\t4");
    ASSERT_TRUE(session().saveTo(file));
    EXPECT_TRUE(saved() == withPoint({3, 4}));
}

} // namespace
} // namespace kriva::ui
