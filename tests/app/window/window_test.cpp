#include "core/io/svg/svg_writer.h"
#include "tests/support/answers.h"
#include "tests/support/test_window.h"
#include "ui/controls/player.h"
#include "ui/document/safe_write.h"
#include "ui/figures/caption_text.h"

#include <gtest/gtest.h>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

namespace kriva::ui {
namespace {

using test::pixelOf;
using test::TestWindow;

/// The same gestures in each tab.
class WindowTest : public testing::TestWithParam<SheetIndex> {
  protected:
    void press(QPoint at, Qt::KeyboardModifiers keys = {}) {
        QTest::mousePress(canvas().viewport(), Qt::LeftButton, keys, at);
    }
    void moveTo(QPoint at) { QTest::mouseMove(canvas().viewport(), at); }
    void release(QPoint at, Qt::KeyboardModifiers keys = {}) {
        QTest::mouseRelease(canvas().viewport(), Qt::LeftButton, keys, at);
    }
    CanvasView& canvas() { return tab.canvas(); }
    [[nodiscard]] const Curve& curve() { return *tab.editor().activeCurve(); }
    [[nodiscard]] int count() { return static_cast<int>(pointCount(curve())); }
    OpenDocument& document() { return window.window.document(); }
    /// A place without a point or a curve.
    [[nodiscard]] QPoint emptyPlace() { return {6, canvas().viewport()->height() - 6}; }

    TestWindow window;
    SheetTab& tab = window.shown(GetParam());
};

TEST_P(WindowTest, aDragOfFiftyMovesIsOneStepAndOneSignalPerMove) {
    const QPoint start = pixelOf(tab, 1);
    const QSignalSpy changes(&document(), &OpenDocument::curveChanged);
    press(start);
    for (int i = 1; i <= 50; ++i)
        moveTo(start + QPoint(i + 4, i));
    EXPECT_EQ(changes.count(), 50);
    release(start + QPoint(54, 50));
    EXPECT_EQ(window.steps(GetParam()), 1);
    EXPECT_NE(curve(), startDocument().sheets[GetParam()].curves[0]);
    QTest::keyClick(&window.window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(curve(), startDocument().sheets[GetParam()].curves[0]);
}

TEST_P(WindowTest, theGridsButtonFollowsItsKey) {
    const QAction& grid = *window.window.findChild<QAction*>(QStringLiteral("grid"));
    ASSERT_TRUE(grid.isChecked());
    QTest::keyClick(&canvas(), Qt::Key_G);
    EXPECT_FALSE(canvas().isGridShown());
    EXPECT_FALSE(grid.isChecked());
    QTest::keyClick(&canvas(), Qt::Key_G);
    EXPECT_TRUE(grid.isChecked());
}

TEST_P(WindowTest, outAndBackIsNoStep) {
    const QPoint start = pixelOf(tab, 1);
    press(start);
    moveTo(start + QPoint(40, 30));
    moveTo(start);
    release(start);
    EXPECT_EQ(window.steps(GetParam()), 0);
    EXPECT_FALSE(document().isModified());
}

TEST_P(WindowTest, escTakesADragBackAndKeepsWhatCanBeRedone) {
    const QPoint start = pixelOf(tab, 1);
    press(start);
    moveTo(start + QPoint(30, 30));
    release(start + QPoint(30, 30));
    document().undo();
    press(start);
    moveTo(start + QPoint(60, 10));
    QTest::keyClick(canvas().viewport(), Qt::Key_Escape);
    release(start + QPoint(60, 10));
    EXPECT_EQ(curve(), startDocument().sheets[GetParam()].curves[0]);
    EXPECT_FALSE(document().isModified());
    EXPECT_TRUE(document().history(GetParam()).canRedo());
}

TEST_P(WindowTest, altClickAddsAndRemoves) {
    const int before = count();
    QTest::mouseClick(canvas().viewport(), Qt::LeftButton, Qt::AltModifier, emptyPlace());
    EXPECT_EQ(count(), before + 1);
    EXPECT_EQ(window.steps(GetParam()), 1);
    QTest::mouseClick(canvas().viewport(), Qt::LeftButton, Qt::AltModifier, pixelOf(tab, before));
    EXPECT_EQ(count(), before);
    EXPECT_EQ(window.steps(GetParam()), 2);
}

TEST_P(WindowTest, aClickSelectsAndDeleteRemoves) {
    const int before = count();
    QTest::mouseClick(canvas().viewport(), Qt::LeftButton, {}, pixelOf(tab, 1));
    EXPECT_EQ(tab.editor().selectedPoints(), std::vector<int>{1});
    QTest::mouseClick(canvas().viewport(), Qt::LeftButton, Qt::ShiftModifier, pixelOf(tab, 0));
    EXPECT_EQ(tab.editor().selectedPoints(), (std::vector<int>{0, 1}));
    QTest::keyClick(canvas().viewport(), Qt::Key_Delete);
    EXPECT_EQ(count(), before - 2);
    EXPECT_EQ(window.steps(GetParam()), 1);
}

TEST_P(WindowTest, aDragWithTheAddToolIsOneStepOrNone) {
    const Curve before = curve();
    const auto drag = [&] {
        canvas().setTool(Tool::add);
        press(emptyPlace());
        moveTo(emptyPlace() + QPoint(20, -20));
        moveTo(emptyPlace() + QPoint(30, -50));
        EXPECT_EQ(tab.editor().selectedPoints(), std::vector<int>{count() - 1});
    };
    drag();
    release(emptyPlace() + QPoint(30, -50));
    EXPECT_EQ(count(), static_cast<int>(pointCount(before)) + 1);
    EXPECT_EQ(window.steps(GetParam()), 1);
    document().undo();
    EXPECT_EQ(curve(), before);
    drag();
    QTest::keyClick(canvas().viewport(), Qt::Key_Escape);
    EXPECT_EQ(curve(), before);
    EXPECT_TRUE(document().history(GetParam()).canRedo());
    tab.editor().clear();
    drag();
    release(emptyPlace() + QPoint(30, -50));
    EXPECT_EQ(window.steps(GetParam()), 2);
    document().undo();
    EXPECT_EQ(tab.editor().activeCurve(), nullptr);
    drag();
    QTest::keyClick(canvas().viewport(), Qt::Key_Escape);
    EXPECT_EQ(tab.editor().activeCurve(), nullptr);
}

TEST_P(WindowTest, deleteIsEnabledWherePointsOfTheActiveCurveAreSelected) {
    const QAction& action = *window.window.findChild<QAction*>(QStringLiteral("deleteSelected"));
    EXPECT_FALSE(action.isEnabled());
    QTest::mouseClick(canvas().viewport(), Qt::LeftButton, {}, pixelOf(tab, 1));
    EXPECT_TRUE(action.isEnabled());
    tab.editor().newCurve();
    EXPECT_FALSE(action.isEnabled());
    document().setActiveCurve(GetParam(), document().serials(GetParam()).front());
    EXPECT_TRUE(action.isEnabled());
    document().setActiveSheet((GetParam() + 1) % kSheetCount);
    EXPECT_FALSE(action.isEnabled());
    document().setActiveSheet(GetParam());
    EXPECT_TRUE(action.isEnabled());
    tab.editor().clear();
    EXPECT_FALSE(action.isEnabled());
}

TEST_P(WindowTest, aRubberBandSelectsAndNudgesAreOneStep) {
    const QRect all = canvas().viewport()->rect().adjusted(3, 3, -3, -3);
    press(all.bottomLeft());
    moveTo(all.center());
    moveTo(all.topRight());
    release(all.topRight());
    EXPECT_EQ(static_cast<int>(tab.editor().selectedPoints().size()), count());
    for (int i = 0; i < 5; ++i)
        QTest::keyClick(canvas().viewport(), Qt::Key_Right);
    document().endGesture();
    EXPECT_EQ(window.steps(GetParam()), 1);
}

TEST_P(WindowTest, savesAndOpensTheSameDocument) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("figure.kriva"));
    QTest::mouseClick(canvas().viewport(), Qt::LeftButton, Qt::AltModifier, emptyPlace());
    ASSERT_TRUE(window.window.session().saveTo(path));
    EXPECT_FALSE(window.window.isWindowModified());
    const Document saved = document().value();
    window.window.session().show({});
    ASSERT_TRUE(window.window.session().openFile(path));
    EXPECT_EQ(document().value(), saved);
    EXPECT_TRUE(window.window.windowTitle().startsWith(QStringLiteral("figure.kriva[*]")));
}

INSTANTIATE_TEST_SUITE_P(InEachTab, WindowTest, testing::Range<SheetIndex>(0, kSheetCount));

class RemovalTest : public testing::Test {
  protected:
    [[nodiscard]] QString hint() { return window.window.findChild<QLabel*>(QStringLiteral("hint"))->text(); }
    void selectByClick(SheetTab& tab, int point) {
        QTest::mouseMove(tab.canvas().viewport(), pixelOf(tab, point));
        QTest::mouseClick(tab.canvas().viewport(), Qt::LeftButton, {}, pixelOf(tab, point));
    }

    TestWindow window;
};

TEST_F(RemovalTest, refitsTheNeighboursOfAKnotAndTellsTheDeviationUntilThePointerMoves) {
    SheetTab& tab = window.shown(test::kSpline);
    const auto before = std::get<SplineCurve>(*tab.editor().activeCurve());
    const Refitted<SplineCurve> refitted = withPointsRemovedRefitted(before, {2});
    const QString told = QStringLiteral("The shape changes by at most %1")
                             .arg(QLocale(QLocale::English).toString(*refitted.deviation, 'g', 3));
    const QPoint knot = pixelOf(tab, 2);
    selectByClick(tab, 2);
    QTest::keyClick(tab.canvas().viewport(), Qt::Key_Delete);
    EXPECT_EQ(*tab.editor().activeCurve(), Curve(refitted.edited.curve));
    EXPECT_EQ(hint(), told);
    QTest::mouseMove(tab.canvas().viewport(), {5, 5});
    QTest::mouseMove(tab.canvas().viewport(), {6, 5});
    EXPECT_NE(hint(), told);
    window.window.document().undo();
    QTest::mouseMove(tab.canvas().viewport(), knot);
    QTest::mouseClick(tab.canvas().viewport(), Qt::LeftButton, Qt::AltModifier, knot);
    EXPECT_EQ(*tab.editor().activeCurve(), Curve(refitted.edited.curve));
    EXPECT_EQ(hint(), told);
}

TEST_F(RemovalTest, ctrlDeleteAndDeleteLastPointRefitNothing) {
    SheetTab& tab = window.shown(test::kSpline);
    const auto before = std::get<SplineCurve>(*tab.editor().activeCurve());
    selectByClick(tab, 2);
    QTest::keyClick(tab.canvas().viewport(), Qt::Key_Delete, Qt::ControlModifier);
    EXPECT_EQ(*tab.editor().activeCurve(), Curve(withPointsRemoved(before, {2}).curve));
    window.window.document().undo();
    tab.editor().removeLastPoint();
    EXPECT_EQ(*tab.editor().activeCurve(),
              Curve(withPointsRemoved(before, {static_cast<int>(before.knots.size()) - 1}).curve));
}

TEST_F(RemovalTest, tellsWhereTheDegreeFalls) {
    for (const SheetIndex sheet : {0U, 1U})
        for (const Qt::KeyboardModifiers keys : {Qt::KeyboardModifiers(), Qt::KeyboardModifiers(Qt::ControlModifier)}) {
            SheetTab& tab = window.shown(sheet);
            const int degree = *polynomialDegree(*tab.editor().activeCurve());
            selectByClick(tab, 1);
            QTest::keyClick(tab.canvas().viewport(), Qt::Key_Delete, keys);
            EXPECT_EQ(hint(), QStringLiteral("The degree falls to %1").arg(degree - 1));
            window.window.document().undo();
        }
}

TEST_F(RemovalTest, leavesAPointByItselfWithoutADegree) {
    SheetTab& tab = window.shown(test::kElevation);
    tab.editor().removePoints(tab.editor().activeSerial(), {1, 2, 3}, Removal::refitted);
    EXPECT_FALSE(hint().startsWith(QStringLiteral("The degree")));
}

TEST_F(RemovalTest, tellsWhatHappenedUntilSomethingElseDoes) {
    SheetTab& tab = window.shown(test::kElevation);
    tab.editor().removePoints(tab.editor().activeSerial(), {1}, Removal::plain);
    EXPECT_EQ(hint(), QStringLiteral("The degree falls to 2"));
    window.window.document().undo();
    EXPECT_EQ(hint(), QString());
}

TEST_F(RemovalTest, looksAgainWhatIsUnderThePointerWhenThePointGoes) {
    SheetTab& tab = window.shown(test::kElevation);
    selectByClick(tab, 1);
    const QString overPoint = hint();
    EXPECT_NE(overPoint, QString());
    tab.editor().placePoint(1, pointAt(*tab.editor().activeCurve(), 1) + Vector{3, 3});
    EXPECT_NE(hint(), overPoint);
}

TEST_F(RemovalTest, forgetsThePointerThatLeft) {
    SheetTab& tab = window.shown(test::kElevation);
    selectByClick(tab, 1);
    const auto& pointer = *window.window.findChild<QLabel*>(QStringLiteral("pointer"));
    EXPECT_TRUE(pointer.text().startsWith(QStringLiteral("x")));
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(tab.canvas().viewport(), &leave);
    EXPECT_EQ(pointer.text(), QString());
    EXPECT_EQ(hint(), QString());
}

using test::answerWith;

TEST(Window, asksWhetherToOpenTheDocumentOrTheDrawingOfAnEditedFigure) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("figure.svg"));
    Document document;
    document.title = "Inside";
    document.sheets[test::kElevation].curves = {
        withPointsAdded(emptyCurve(test::kElevation), Points{{0, 0}, {1, 4}, {4, 0}})};
    const std::string svg = writeSheetSvg(document, test::kElevation, textSource(), {{}, 10});
    const auto save = [&](std::string_view without, std::string_view with) {
        std::string text = svg;
        ASSERT_NE(text.find(without), std::string::npos);
        text.replace(text.find(without), without.size(), with);
        EXPECT_FALSE(safeWrite(path, QByteArray::fromStdString(text)));
    };
    TestWindow window;
    DocumentSession& session = window.window.session();
    const Document before = window.window.document().value();
    save("Q 16,6 46,46", "Q 16,6 56,46");
    answerWith(QStringLiteral("Cancel"));
    EXPECT_FALSE(session.openFile(path));
    EXPECT_EQ(window.window.document().value(), before);
    answerWith(QStringLiteral("Document"));
    EXPECT_TRUE(session.openFile(path));
    EXPECT_EQ(window.window.document().value(), document);
    answerWith(QStringLiteral("Drawing"));
    EXPECT_TRUE(session.openFile(path));
    EXPECT_EQ(pointAt(window.window.document().sheet(test::kElevation).curves.at(0), 2), (Point{5, 0}));
    EXPECT_EQ(window.window.document().value().title, "Inside");
    save("Q", "Q"); // as it was: nobody is asked
    EXPECT_TRUE(session.openFile(path));
    EXPECT_EQ(window.window.document().value(), document);
    const auto actions = window.window.findChildren<QAction*>();
    EXPECT_TRUE(std::ranges::any_of(actions, [&](const QAction* action) {
        return action->text().endsWith(QStringLiteral("figure.svg"));
    })) << "it is a recent file at once";
}

TEST(Window, asksForAFurtherOne) {
    TestWindow window;
    const QSignalSpy asked(&window.window, &MainWindow::newWindowAsked);
    window.window.findChild<QAction*>(QStringLiteral("newWindow"))->trigger();
    EXPECT_EQ(asked.size(), 1);
}

TEST(Window, asksBeforeChangesAreLost) {
    TestWindow window;
    SheetTab& tab = window.shown(test::kElevation);
    EXPECT_TRUE(window.window.session().mayClose());
    tab.editor().addPoint({1, 1});
    answerWith(QMessageBox::Cancel);
    EXPECT_FALSE(window.window.close());
    EXPECT_TRUE(window.window.document().isModified());
    answerWith(QMessageBox::Discard);
    EXPECT_TRUE(window.window.close());
}

TEST(Window, staysModifiedAfterAFailedSave) {
    TestWindow window;
    window.shown(test::kElevation).editor().addPoint({1, 1});
    answerWith(QMessageBox::Cancel);
    EXPECT_FALSE(window.window.session().saveTo(QStringLiteral("/nowhere/at/all.kriva")));
    EXPECT_TRUE(window.window.document().isModified());
}

TEST(Window, keepsItsDocumentWhereAFileIsRefused) {
    TestWindow window;
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("bad.kriva"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{\"format\": \"other\"}");
    file.close();
    answerWith(QMessageBox::Ok);
    EXPECT_FALSE(window.window.session().openFile(path));
    EXPECT_EQ(window.window.document().value(), startDocument());
}

TEST(Window, remembersThePanelsOfEachTabAlsoOfThoseThatWereNotShown) {
    const auto points = [](TestWindow& window, SheetIndex sheet) {
        return window.shown(sheet).findChild<QDockWidget*>(QStringLiteral("points"));
    };
    {
        TestWindow window;
        points(window, 2)->close();
        window.window.close();
    }
    {
        TestWindow window; // its tab for splines is never shown
        points(window, 3)->close();
        window.window.close();
    }
    TestWindow window;
    EXPECT_TRUE(points(window, 0)->isVisible());
    EXPECT_FALSE(points(window, 2)->isVisible());
    EXPECT_FALSE(points(window, 3)->isVisible());
    window.shown(test::kSpline).panels().reset();
    EXPECT_TRUE(points(window, 2)->isVisible());
}

TEST(Window, makesThePanelsOfATabWhenItIsFirstShown) {
    TestWindow window;
    EXPECT_EQ(window.window.tab(test::kSubdivision).findChild<QDockWidget*>(), nullptr);
    EXPECT_NE(window.shown(test::kSubdivision).findChild<QDockWidget*>(), nullptr);
}

TEST(Window, opensEveryExample) {
    TestWindow window;
    for (const Example& example : examples()) {
        window.window.session().openExample(QString::fromLatin1(example.resource));
        QApplication::processEvents();
        EXPECT_FALSE(window.window.currentTab().editor().sheet().curves.empty()) << example.resource;
        EXPECT_FALSE(window.window.isWindowModified());
    }
}

TEST(Window, playsThroughStagesWithoutTouchingTheDocument) {
    TestWindow window;
    SheetTab& tab = window.shown(test::kElevation);
    auto* player = tab.findChild<Player*>();
    for (int i = 0; i < 20; ++i)
        player->tick();
    EXPECT_TRUE(tab.editor().hasStage());
    EXPECT_FALSE(window.window.document().isModified());
    EXPECT_EQ(window.steps(0), 0);
    QTest::mouseClick(player->findChild<QToolButton*>(QStringLiteral("keep")), Qt::LeftButton);
    EXPECT_EQ(window.steps(0), 1);
    EXPECT_FALSE(tab.editor().hasStage());
    EXPECT_EQ(std::get<ElevationCurve>(*tab.editor().activeCurve()).times, 25);
}

TEST(Window, bringsTheHistoryToTheFront) {
    TestWindow window;
    SheetTab& tab = window.shown(test::kSubdivision);
    auto* history = tab.findChild<QDockWidget*>(QStringLiteral("history"));
    ASSERT_TRUE(history->visibleRegion().isEmpty()); // behind the results
    QTest::keyClick(&window.window, Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
    QApplication::processEvents();
    EXPECT_FALSE(history->visibleRegion().isEmpty());
    EXPECT_TRUE(history->widget()->hasFocus());
}

TEST(Window, tellsTheZoomOfTheShownTab) {
    TestWindow shell;
    const auto* zoom = shell.window.findChild<QLabel*>(QStringLiteral("zoom"));
    const QLocale locale;
    for (const SheetIndex sheet : {0, 1, 0}) {
        SheetTab& tab = shell.shown(sheet);
        test::settle();
        EXPECT_EQ(zoom->text(), locale.toString(tab.canvas().zoomPercent(), 'g', 3) + QStringLiteral(" %"));
        EXPECT_GE(zoom->width(), zoom->sizeHint().width()) << "there is room for it";
    }
    shell.window.currentTab().canvas().zoomIn();
    shell.window.tab(test::kCombined).canvas().zoomTo100();
    EXPECT_EQ(zoom->text(),
              locale.toString(shell.window.currentTab().canvas().zoomPercent(), 'g', 3) + QStringLiteral(" %"));
}

} // namespace
} // namespace kriva::ui
