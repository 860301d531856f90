#include "core/curve/limits.h"
#include "core/document/conversion.h"
#include "core/document/sheet_figure.h"
#include "tests/support/panel_test.h"

#include <QClipboard>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>

namespace kriva::ui {
namespace {

constexpr Qt::KeyboardModifier kCtrl = Qt::ControlModifier;

/// The same keys in each tab.
class ClipboardTest : public test::PanelTest, public testing::WithParamInterface<SheetIndex> {
  protected:
    ClipboardTest()
        : PanelTest(GetParam()) {
        open({line("One", {{0, 0}, {1, 2}, {3, 1}, {5, 4}})});
        tab.canvas().setFocus();
        QGuiApplication::clipboard()->clear();
    }
    [[nodiscard]] Curve line(const char* name, const Points& points) const {
        return renamed(withPointsAdded(emptyCurve(sheet_), points), name);
    }
    void key(Qt::Key key) { QTest::keyClick(&tab.canvas(), key, kCtrl); }
    void setText(const char* text) { QGuiApplication::clipboard()->setText(QString::fromUtf8(text)); }
    [[nodiscard]] static QString text() { return QGuiApplication::clipboard()->text(); }
    [[nodiscard]] QString told() { return shell.window.findChild<QLabel*>(QStringLiteral("hint"))->text(); }
    [[nodiscard]] std::size_t curves() { return editor().sheet().curves.size(); }
};

TEST_P(ClipboardTest, copiedPointsComeBehindTheOthersInOneStep) {
    const Curve before = curve();
    selectPoints({1, 3});
    key(Qt::Key_C);
    expectNoStep(before);
    EXPECT_EQ(text(), QStringLiteral("1\t2\n5\t4"));
    key(Qt::Key_V);
    EXPECT_EQ(pointsOf(curve()), (Points{{0, 0}, {1, 2}, {3, 1}, {5, 4}, {1, 2}, {5, 4}}));
    EXPECT_EQ(editor().selectedPoints(), (std::vector<int>{4, 5}));
    EXPECT_EQ(steps(), QStringList(QStringLiteral("Paste points")));
    document().undo();
    EXPECT_EQ(curve(), before);
}

TEST_P(ClipboardTest, cutPointsGoInOneStep) {
    const Curve before = curve();
    selectPoints({1});
    key(Qt::Key_X);
    EXPECT_EQ(pointsOf(curve()), (Points{{0, 0}, {3, 1}, {5, 4}}));
    EXPECT_EQ(text(), QStringLiteral("1\t2"));
    EXPECT_EQ(steps(), QStringList(QStringLiteral("Cut points")));
    document().undo();
    EXPECT_EQ(curve(), before);
}

TEST_P(ClipboardTest, shiftAndDeleteCutNothing) {
    setText("kept");
    selectPoints({1});
    QTest::keyClick(&tab.canvas(), Qt::Key_Delete, Qt::ShiftModifier);
    EXPECT_EQ(text(), QStringLiteral("kept"));
}

TEST_P(ClipboardTest, duplicatesPointsPastTheClipboard) {
    setText("kept");
    selectPoints({0, 2});
    key(Qt::Key_D);
    EXPECT_EQ(pointsOf(curve()), (Points{{0, 0}, {1, 2}, {3, 1}, {5, 4}, {0, 0}, {3, 1}}));
    EXPECT_EQ(steps(), QStringList(QStringLiteral("Duplicate points")));
    EXPECT_EQ(text(), QStringLiteral("kept"));
}

TEST_P(ClipboardTest, withoutSelectedPointsTheCurveIsMeant) {
    const Curve before = curve();
    key(Qt::Key_C);
    const QMimeData* clip = QGuiApplication::clipboard()->mimeData();
    EXPECT_EQ(clip->data(QStringLiteral("image/svg+xml")).count("<path"), 1);
    EXPECT_EQ(text(), QStringLiteral("0\t0\n1\t2\n3\t1\n5\t4"));
    key(Qt::Key_V);
    ASSERT_EQ(curves(), 2u);
    EXPECT_EQ(curve(), before);
    EXPECT_EQ(editor().sheet().view.activeCurve, 1);
    key(Qt::Key_D);
    EXPECT_EQ(curves(), 3u);
    key(Qt::Key_X);
    EXPECT_EQ(curves(), 2u);
    EXPECT_EQ(steps(), (QStringList{QStringLiteral("Paste the curve"), QStringLiteral("Duplicate the curve"),
                                    QStringLiteral("Cut the curve")}));
    for (int i = 0; i < 3; ++i)
        document().undo();
    EXPECT_EQ(editor().sheet().curves, std::vector<Curve>{before});
}

TEST_P(ClipboardTest, aCurveOfAnotherTabGivesItsPoints) {
    key(Qt::Key_C);
    const SheetIndex other = (sheet_ + 1) % kSheetCount;
    SheetTab& otherTab = shell.shown(other);
    const std::size_t before = document().sheet(other).curves.size();
    QTest::keyClick(&otherTab.canvas(), Qt::Key_V, kCtrl);
    ASSERT_EQ(document().sheet(other).curves.size(), before + 1);
    EXPECT_EQ(*otherTab.editor().activeCurve(), converted(curve(), other));
    EXPECT_EQ(steps(), QStringList()) << "a step of the other tab alone";
    EXPECT_EQ(shell.steps(other), 1);
}

TEST_P(ClipboardTest, aTableOfNumbersIsAddedInOneStep) {
    const Curve before = curve();
    for (const char* table : {"0,5\t1\n2\t-0,25\n", "0.5;1\n2;-0.25", "0.5,1\r\n2,-0.25\r\n"}) {
        setText(table);
        key(Qt::Key_V);
        EXPECT_EQ(pointsOf(curve()), (Points{{0, 0}, {1, 2}, {3, 1}, {5, 4}, {0.5, 1}, {2, -0.25}}));
        EXPECT_EQ(steps(), QStringList(QStringLiteral("Paste points")));
        document().undo();
        EXPECT_EQ(curve(), before);
    }
}

TEST_P(ClipboardTest, aTableIntoAnEmptySheetIsANewCurve) {
    open({});
    setText("1\t2\n3\t4");
    key(Qt::Key_V);
    EXPECT_EQ(pointsOf(curve()), (Points{{1, 2}, {3, 4}}));
    EXPECT_EQ(steps(), QStringList(QStringLiteral("Paste points")));
    document().undo();
    EXPECT_EQ(editor().activeCurve(), nullptr);
}

TEST_P(ClipboardTest, pathDataBecomesCurvesInOneStep) {
    setText("M10 0C10 -5 20 -5 20 0M0 0h5v5");
    key(Qt::Key_V);
    ASSERT_EQ(curves(), 3U);
    EXPECT_EQ(pointsOf(curve()), (Points{{0, 0}, {5, 0}, {5, -5}}));
    EXPECT_EQ(steps(), QStringList(QStringLiteral("Paste curves")));
    document().undo();
    EXPECT_EQ(curves(), 1U);
    document().redo();
    EXPECT_EQ(curves(), 3U);
}

TEST_P(ClipboardTest, aCopiedPathIsPastedAsTheSameCurve) {
    if (sheet_ == 3)
        GTEST_SKIP() << "a path has no polynomials";
    open({line("One", {{0, 0}, {1, 2}, {3, 2}, {4, 0.5}})});
    shell.window.findChild<QAction*>(QStringLiteral("copyPath"))->trigger();
    EXPECT_TRUE(text().startsWith(QStringLiteral("M 0,0 C "))) << text().toStdString();
    const Figure before = figureOf(curve(), {0, false});
    key(Qt::Key_V);
    EXPECT_EQ(curves(), 2U);
    const auto pathOf = [](const Figure& figure) {
        const auto layer = std::ranges::find(figure.layers, "curve", &Layer::name);
        return layer->strokes.front().path;
    };
    const Points after = pathOf(figureOf(curve(), {0, false})).points;
    const Points expected = pathOf(before).points;
    ASSERT_EQ(after.size(), expected.size());
    for (std::size_t i = 0; i < after.size(); ++i)
        EXPECT_LT(distance(after[i], expected[i]), 1e-11);
}

TEST_P(ClipboardTest, badTextIsRefusedInOneLineThatNamesThePlace) {
    const Curve before = curve();
    for (const auto& [table, line] :
         {std::pair{"", "The clipboard: there are no points"},
          {"1\t2\nthree\t4", "The clipboard: line 2, column 1: “three” is no number"},
          {"1\t2\t3", "The clipboard: line 1, column 5: expected two numbers"},
          {"2e9\t0", "The clipboard: line 1, column 1: “2e9” is not from -1000000000 to 1000000000"}}) {
        setText(table);
        key(Qt::Key_V);
        EXPECT_EQ(told(), QString::fromUtf8(line));
        expectNoStep(before);
    }
}

TEST_P(ClipboardTest, aDamagedFragmentIsRefused) {
    const Curve before = curve();
    auto* clip = new QMimeData;
    clip->setData(QStringLiteral("application/x-kriva-fragment+json"), "{\"format\":\"kriva-fragment\"}");
    clip->setText(QStringLiteral("1\t2"));
    QGuiApplication::clipboard()->setMimeData(clip);
    key(Qt::Key_V);
    EXPECT_TRUE(told().startsWith(QStringLiteral("The clipboard: "))) << told().toStdString();
    expectNoStep(before);
}

TEST_P(ClipboardTest, pointsBeyondTheLimitsAreRefusedAndTheLimitIsNamed) {
    const Curve before = curve();
    const auto beyond = pointLimitError(withPointsAdded(curve(), Points(limits::kPointsInCurve))).value();
    const auto most = static_cast<qsizetype>(beyond.numbers.front());
    const auto room = most - static_cast<qsizetype>(pointCount(curve()));
    setText(QByteArray("1\t2\n3\t4\n").repeated(room / 2 + 1).constData());
    key(Qt::Key_V);
    EXPECT_TRUE(told().contains(QString::number(most))) << told().toStdString();
    expectNoStep(before);
}

TEST_P(ClipboardTest, inAnEmptySheetThereIsNothingToCopy) {
    setText("kept");
    open({});
    for (const Qt::Key pressed : {Qt::Key_C, Qt::Key_X, Qt::Key_D})
        key(pressed);
    EXPECT_EQ(text(), QStringLiteral("kept"));
    EXPECT_EQ(steps(), QStringList());
}

INSTANTIATE_TEST_SUITE_P(EachTab, ClipboardTest, testing::Range<SheetIndex>(0, kSheetCount));

class MultiplicityClipboardTest : public test::PanelTest {
  protected:
    MultiplicityClipboardTest()
        : PanelTest(test::kSubdivision) {}
};

TEST_F(MultiplicityClipboardTest, pointsKeepWhatBelongsToThem) {
    SubdivisionCurve cut;
    cut.points = {{0, 0}, {1, 2}, {3, 0}};
    cut.multiplicity = {1, 3, 1};
    open({cut});
    selectPoints({1});
    QTest::keyClick(&tab.canvas(), Qt::Key_C, kCtrl);
    QTest::keyClick(&tab.canvas(), Qt::Key_V, kCtrl);
    EXPECT_EQ(value<SubdivisionCurve>().multiplicity, (std::vector<int>{1, 3, 1, 3}));
}

} // namespace
} // namespace kriva::ui
