#include "core/document/sheet_figure.h"
#include "core/sheets/subdivision/subdivision.h"
#include "tests/support/panel_test.h"
#include "ui/controls/player.h"
#include "ui/tabs/properties/properties_panel.h"

#include <QSignalSpy>

#include <gmock/gmock.h>

namespace kriva::ui {
namespace {

using test::click;
using test::dragHandle;
using test::named;
using test::type;
using testing::ElementsAre;

class SubdivisionPropertiesTest : public test::PanelTest {
  protected:
    SubdivisionPropertiesTest()
        : PanelTest(test::kSubdivision) {}
    [[nodiscard]] QCheckBox& box(const char* text) { return test::saying<QCheckBox>(properties, text); }

    PropertiesPanel& properties = panel<PropertiesPanel>("properties");
    NumberField& t = named<NumberField>(properties, "Parameter t");
    NumberField& levels = named<NumberField>(properties, "Levels");
    NumberField& multiplicity = named<NumberField>(properties, "Multiplicity of the selected point");
    QLineEdit& arguments = named<QLineEdit>(properties, "Arguments");
    const SubdivisionCurve before = value<SubdivisionCurve>(); // a cubic cut once at t = 0.4
};

TEST_F(SubdivisionPropertiesTest, aDragOfTIsOneStep) {
    dragHandle(named<QSlider>(properties, "Parameter t"), -20);
    SubdivisionCurve after = before;
    after.t = t.value();
    EXPECT_LT(after.t, 0.4);
    expectOneStep("Set the parameter t", before, after);
    EXPECT_EQ(t.value(), 0.4);
}

TEST_F(SubdivisionPropertiesTest, clicksOnTheButtonsOfTAreOneStepInABurst) {
    QToolButton& more = named<QToolButton>(*t.parentWidget(), "More");
    click(more);
    click(more);
    SubdivisionCurve after = before;
    after.t = 0.42;
    expectOneStep("Set the parameter t", before, after);
}

TEST_F(SubdivisionPropertiesTest, pointAndCommaSetTAlike) {
    for (const char* text : {"0,125", "0.125"}) {
        type(t, text);
        SubdivisionCurve after = before;
        after.t = 0.125;
        expectOneStep("Set the parameter t", before, after);
    }
}

TEST_F(SubdivisionPropertiesTest, refusedNumbersChangeNothing) {
    for (const char* text : {"0", "1", "1,5", "-0.5", "half"})
        type(t, text);
    for (const char* text : {"-1", "17", "1,5"})
        type(levels, text);
    selectPoints({1});
    for (const char* text : {"0", "199", "1,5"})
        type(multiplicity, text);
    expectNoStep(before);
}

TEST_F(SubdivisionPropertiesTest, levelsAreSetInOneStep) {
    SubdivisionCurve after = before;
    after.levels = 3;
    type(levels, "3");
    expectOneStep("Set the levels", before, after);
    click(named<QToolButton>(*levels.parentWidget(), "More"));
    after.levels = 2;
    expectOneStep("Set the levels", before, after);
    EXPECT_EQ(levels.value(), 1);
}

TEST_F(SubdivisionPropertiesTest, showingTheCurveIsNoChange) {
    QCheckBox& shows = box("Show the curve");
    EXPECT_FALSE(shows.isChecked());
    click(shows);
    EXPECT_TRUE(editor().sheet().view.layers.at("curve"));
    expectNoStep(before);
    EXPECT_FALSE(document().isModified());
    document().setLayerShown(test::kSubdivision, "curve", false);
    EXPECT_FALSE(shows.isChecked());
}

TEST_F(SubdivisionPropertiesTest, thePiecesAreShownBesideTheLevels) {
    EXPECT_FALSE(box("Show the pieces").isChecked());
    click(box("Show the pieces"));
    EXPECT_TRUE(editor().sheet().view.layers.at("pieces"));
    expectNoStep(before);
}

TEST_F(SubdivisionPropertiesTest, theMultiplicityIsThatOfTheSelectedPoints) {
    EXPECT_FALSE(multiplicity.isEnabled());
    selectPoints({1, 2});
    EXPECT_TRUE(multiplicity.isEnabled());
    type(multiplicity, "3");
    SubdivisionCurve after = before;
    after.multiplicity = {1, 3, 3, 1};
    expectOneStep("Set the multiplicity", before, after);
    EXPECT_EQ(multiplicity.value(), 1);
}

TEST_F(SubdivisionPropertiesTest, manySelectedPointsStandOnlyAsOftenAsTheCurveHasRoomForAll) {
    selectPoints({0, 1, 2, 3});
    type(multiplicity, "51"); // 204 control points
    expectNoStep(before);
    EXPECT_FALSE(multiplicity.accessibleDescription().isEmpty());
    type(multiplicity, "50");
    SubdivisionCurve after = before;
    after.multiplicity = {50, 50, 50, 50};
    expectOneStep("Set the multiplicity", before, after);
}

TEST_F(SubdivisionPropertiesTest, theBlossomComesAndGoesInOneStepEach) {
    EXPECT_FALSE(arguments.isEnabled());
    click(box("Show the blossom"));
    SubdivisionCurve after = before;
    after.blossom = {0.4, 0.4, 0.4};
    EXPECT_EQ(arguments.text(), QStringLiteral("0.4; 0.4; 0.4"));
    expectOneStep("Show the blossom", before, after);
    EXPECT_FALSE(box("Show the blossom").isChecked());
    open({after});
    click(box("Show the blossom"));
    expectOneStep("Hide the blossom", after, before);
    EXPECT_TRUE(box("Show the blossom").isChecked());
}

TEST_F(SubdivisionPropertiesTest, theBlossomTakesAsManyArgumentsAsTheDegree) {
    SubdivisionCurve with = before;
    with.blossom = {0.25, 0.5, 0.75};
    open({with});
    SubdivisionCurve after = with;
    after.blossom = {0.1, 0.2, -3};
    type(arguments, "0,1; 0.2 -3");
    expectOneStep("Set the blossom", with, after);
    for (const char* text : {"0.5 0.5", "1 2 3 4", "a b c", "2e9 0 0", ""}) {
        type(arguments, text);
        EXPECT_EQ(arguments.text(), QString::fromLatin1(text)) << "refused in place";
        EXPECT_TRUE(arguments.accessibleDescription().startsWith(QStringLiteral("3 numbers"))) << text;
        tab.canvas().setFocus();
        EXPECT_EQ(arguments.text(), QStringLiteral("0.25; 0.5; 0.75")) << text;
        EXPECT_TRUE(arguments.accessibleDescription().isEmpty());
    }
    EXPECT_TRUE(curve() == Curve(with));
}

TEST_F(SubdivisionPropertiesTest, furtherParametersAreOfTheViewAndShownAtOnce) {
    QLineEdit& further = named<QLineEdit>(properties, "Further t");
    EXPECT_EQ(further.text(), QString());
    type(further, "0,25; 0.75");
    EXPECT_THAT(numbersOf(&editor().sheet().view, kFurtherParameters), ElementsAre(0.25, 0.75));
    EXPECT_EQ(further.text(), QStringLiteral("0.25; 0.75"));
    const Figure figure = figureOf(editor().sheet(), test::kSubdivision);
    const auto layer = std::ranges::find(figure.layers, "further-constructions", &Layer::name);
    ASSERT_NE(layer, figure.layers.end());
    EXPECT_EQ(layer->strokes.size(), 4u);
    expectNoStep(before);
    EXPECT_FALSE(document().isModified());
    type(further, "");
    EXPECT_TRUE(numbersOf(&editor().sheet().view, kFurtherParameters).empty());
}

TEST_F(SubdivisionPropertiesTest, furtherParametersBetweenNoughtAndOneAloneAreTaken) {
    QLineEdit& further = named<QLineEdit>(properties, "Further t");
    document().setViewNumbers(test::kSubdivision, kFurtherParameters, {0.5});
    EXPECT_EQ(further.text(), QStringLiteral("0.5"));
    for (const char* text : {"1", "0", "0.5; t", ".1 .1 .1 .1 .1 .1 .1 .1 .1 .1 .1 .1 .1 .1 .1 .1 .1"}) {
        type(further, text);
        EXPECT_EQ(further.text(), QString::fromLatin1(text)) << "refused in place";
        EXPECT_TRUE(further.accessibleDescription().contains(QStringLiteral("16"))) << text;
        tab.canvas().setFocus();
        EXPECT_EQ(further.text(), QStringLiteral("0.5")) << text;
    }
    EXPECT_THAT(numbersOf(&editor().sheet().view, kFurtherParameters), ElementsAre(0.5));
}

TEST_F(SubdivisionPropertiesTest, isDisabledInAnEmptySheetAndShowsAHalfDrawnCurve) {
    editor().clear();
    for (const QWidget* field : std::initializer_list<QWidget*>{&t, &levels, &multiplicity, &arguments})
        EXPECT_FALSE(field->isEnabled());
    editor().addPoint({1, 1});
    EXPECT_TRUE(t.isEnabled());
    EXPECT_FALSE(box("Show the blossom").isEnabled());
}

TEST_F(SubdivisionPropertiesTest, theAnimationRunsOverTOrOverLevelsAndIsKeptInOneStep) {
    auto& player = *properties.findChild<Player*>();
    QToolButton& keep = *player.findChild<QToolButton*>(QStringLiteral("keep"));
    const auto says = [&](const char* text) {
        const QList<QLabel*> labels = player.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) { return label->text() == QLatin1String(text); });
    };
    EXPECT_TRUE(says("t = 0.4"));
    player.tick();
    EXPECT_TRUE(says("t = 0.41"));
    expectNoStep(before);
    click(keep);
    SubdivisionCurve after = before;
    after.t = 0.41;
    expectOneStep("Keep the stage", before, after);
    QTest::keyClick(&named<QComboBox>(properties, "Runs over"), Qt::Key_Down);
    EXPECT_EQ(player.stage(), 1);
    player.tick();
    player.tick();
    EXPECT_TRUE(says("2<sup>3</sup> = 8"));
    click(keep);
    after = before;
    after.levels = 3;
    expectOneStep("Keep the stage", before, after);
}

TEST_F(SubdivisionPropertiesTest, theAnimationStopsWhereItsCurveGoes) {
    auto& player = *properties.findChild<Player*>();
    click(*player.findChild<QToolButton*>(QStringLiteral("play")));
    EXPECT_TRUE(player.isPlaying());
    editor().clear();
    EXPECT_FALSE(player.isPlaying());
}

TEST_F(SubdivisionPropertiesTest, splittingMakesTwoCurvesInOneStep) {
    const auto parts = *dividedAtCut(before);
    click(test::saying<QPushButton>(properties, "Split here"));
    EXPECT_EQ(editor().sheet().curves, test::curves({parts[0], parts[1]}));
    EXPECT_EQ(curve(), Curve(parts[0]));
    EXPECT_EQ(steps(), QStringList{QStringLiteral("Split the curve")});
    document().undo();
    EXPECT_EQ(editor().sheet().curves, test::curves({before}));
    document().redo();
    EXPECT_EQ(editor().sheet().curves.size(), 2u);
}

TEST_F(SubdivisionPropertiesTest, splittingIsDoneWhereTheStageOnViewIsCut) {
    properties.findChild<Player*>()->tick();
    const auto stage = std::get<SubdivisionCurve>(*editor().shown(editor().activeSerial()));
    ASSERT_NE(stage.t, before.t);
    shell.window.findChild<QAction*>(QStringLiteral("splitHere"))->trigger();
    EXPECT_EQ(curve(), Curve((*dividedAtCut(stage))[0]));
    EXPECT_FALSE(editor().hasStage());
}

} // namespace
} // namespace kriva::ui
