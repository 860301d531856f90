#include "core/io/svg/svg_writer.h"
#include "tests/support/panel_test.h"
#include "ui/figures/caption_text.h"
#include "ui/panels/curves_panel.h"
#include "ui/panels/style_editor.h"

#include <QComboBox>
#include <QPushButton>
#include <QToolButton>

namespace kriva::ui {
namespace {

using test::click;
using test::named;

class StyleEditorTest : public test::PanelTest, public testing::WithParamInterface<SheetIndex> {
  protected:
    StyleEditorTest()
        : PanelTest(GetParam()) {
        const Points points{{0, 0}, {1, 2}, {3, 1}};
        open({withPointsAdded(emptyCurve(sheet_), points)});
        click(named<QToolButton>(panel<CurvesPanel>("curves"), "Style of the curve"));
        QApplication::processEvents();
    }
    /// Goes down so many entries by keys.
    void choose(const char* box, int entries) {
        auto& combo = named<QComboBox>(editorOfStyle, box);
        combo.setFocus();
        for (int i = 0; i < entries; ++i)
            QTest::keyClick(&combo, Qt::Key_Down);
    }
    [[nodiscard]] CurveStyle style() { return styleOf(curve()); }
    [[nodiscard]] QString svg() {
        return QString::fromStdString(writeSvg(drawingOf(document().value(), sheet_, textSource()), textSource()));
    }
    /// Of the curve's own path.
    [[nodiscard]] QString path() {
        const QString all = svg();
        const qsizetype start = all.indexOf(QStringLiteral("<path id=\"curve-0\""));
        return all.mid(start, all.indexOf(QLatin1Char('>'), start) - start);
    }
    void expectStep(const char* name) { EXPECT_EQ(steps(), QStringList(QString::fromUtf8(name))); }
    void expectUndone() {
        document().undo();
        EXPECT_EQ(style(), CurveStyle());
    }

    StyleEditor& editorOfStyle = *tab.findChild<StyleEditor*>();
};

TEST_P(StyleEditorTest, isHiddenUntilItIsAskedFor) {
    EXPECT_TRUE(editorOfStyle.isVisible());
    click(named<QToolButton>(panel<CurvesPanel>("curves"), "Style of the curve"));
    EXPECT_FALSE(editorOfStyle.isVisible());
}

TEST_P(StyleEditorTest, setsTheWidth) {
    test::type(named<NumberField>(editorOfStyle, "Width of the line"), "2,5");
    EXPECT_EQ(style().width, 2.5);
    expectStep("Set the width of the line");
    EXPECT_TRUE(path().contains(QStringLiteral("stroke-width=\"0.8819\""))) << path().toStdString();
    expectUndone();
    test::type(named<NumberField>(editorOfStyle, "Width of the line"), "20.5");
    EXPECT_EQ(steps(), QStringList()) << "wider than any line may be";
}

TEST_P(StyleEditorTest, setsTheDashes) {
    choose("Line", 1);
    EXPECT_EQ(style().dash, LineDash::dashed);
    expectStep("Set the dashes of the line");
    EXPECT_TRUE(path().contains(QStringLiteral("stroke-dasharray=\"1.0583 0.5292\""))) << path().toStdString();
    expectUndone();
}

TEST_P(StyleEditorTest, setsTheMarksOfThePoints) {
    const qsizetype before = svg().count(QStringLiteral("<polygon"));
    choose("Marks of the points", 4);
    EXPECT_EQ(style().marker, Marker::diamond);
    expectStep("Set the marks of the points"); // passing over entries is one
    EXPECT_EQ(svg().count(QStringLiteral("<polygon")), before + 3);
}

TEST_P(StyleEditorTest, hidesTheLabels) {
    EXPECT_GT(svg().count(QStringLiteral("<text")), 0);
    click(named<QCheckBox>(editorOfStyle, "Labels"));
    EXPECT_FALSE(style().hasLabels);
    expectStep("Hide the labels");
    EXPECT_EQ(svg().count(QStringLiteral("<text")), 0);
    expectUndone();
    EXPECT_TRUE(named<QCheckBox>(editorOfStyle, "Labels").isChecked());
}

TEST_P(StyleEditorTest, goesBackToTheUsualStyle) {
    auto& reset = named<QPushButton>(editorOfStyle, "Usual style");
    EXPECT_FALSE(reset.isEnabled());
    choose("Line", 2);
    click(named<QCheckBox>(editorOfStyle, "Labels"));
    click(reset);
    EXPECT_EQ(style(), CurveStyle());
    EXPECT_EQ(steps().back(), QStringLiteral("Reset the style"));
    EXPECT_EQ(named<QComboBox>(editorOfStyle, "Line").currentIndex(), 0);
}

TEST_P(StyleEditorTest, showsTheStyleOfTheActiveCurve) {
    CurveStyle dotted;
    dotted.dash = LineDash::dotted;
    dotted.width = 3;
    dotted.hasLabels = false;
    open({emptyCurve(sheet_), withStyle(emptyCurve(sheet_), dotted)});
    EXPECT_EQ(named<QComboBox>(editorOfStyle, "Line").currentIndex(), 0);
    editor().activateNextCurve();
    EXPECT_EQ(named<QComboBox>(editorOfStyle, "Line").currentText(), QStringLiteral("Dotted"));
    EXPECT_EQ(named<NumberField>(editorOfStyle, "Width of the line").value(), 3);
    EXPECT_FALSE(named<QCheckBox>(editorOfStyle, "Labels").isChecked());
    EXPECT_EQ(steps(), QStringList());
}

INSTANTIATE_TEST_SUITE_P(EachTab, StyleEditorTest, testing::Range<SheetIndex>(0, kSheetCount));

} // namespace
} // namespace kriva::ui
