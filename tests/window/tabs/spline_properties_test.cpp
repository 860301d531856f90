#include "core/sheets/spline/editing/chain_edits.h"
#include "core/sheets/spline/editing/joins.h"
#include "tests/support/panel_test.h"
#include "ui/panels/result_text.h"
#include "ui/tabs/properties/properties_panel.h"
#include "ui/tabs/spline/built_in_drawing.h"

namespace kriva::ui {
namespace {

double deviationOf(const SplineCurve& curve, int points) {
    return withoutLimit([&](WorkBudget& budget) { return deviationFromBuiltIn(curve, points, budget); });
}

using test::click;
using test::dragHandle;
using test::named;
using test::type;

class SplinePropertiesTest : public test::PanelTest {
  protected:
    SplinePropertiesTest()
        : PanelTest(test::kSpline) {}

    PropertiesPanel& properties = panel<PropertiesPanel>("properties");
    QComboBox& rule = named<QComboBox>(properties, "Rule");
    QComboBox& join = named<QComboBox>(properties, "Join");
    QSlider& slider = named<QSlider>(properties, "Degree");
    NumberField& degree = named<NumberField>(properties, "Degree");
    QWidget& start = named<QWidget>(properties, "Start"); ///< the row of the start derivative
    QWidget& end = named<QWidget>(properties, "End");
    QCheckBox& closed = *properties.findChild<QCheckBox*>(QString(), Qt::FindDirectChildrenOnly);
    const SplineCurve before = value<SplineCurve>(); // a natural cubic spline of six knots
};

TEST_F(SplinePropertiesTest, theRuleIsSetInOneStep) {
    QTest::keyClick(&rule, Qt::Key_Down);
    expectOneStep("Set the rule", before, withRule(before, SplineCurve::Rule::clamped));
    EXPECT_EQ(rule.currentText(), QStringLiteral("Natural"));
}

TEST_F(SplinePropertiesTest, theDegreeIsSetInOneStepByHandleButtonsOrTyping) {
    dragHandle(slider, slider.width());
    expectOneStep("Set the degree", before, withDegree(before, 5));
    click(named<QToolButton>(*slider.parentWidget(), "More"));
    click(named<QToolButton>(*slider.parentWidget(), "More"));
    expectOneStep("Set the degree", before, withDegree(before, 5));
    type(degree, "4");
    expectOneStep("Set the degree", before, withDegree(before, 4));
    EXPECT_EQ(degree.value(), 3);
}

TEST_F(SplinePropertiesTest, refusedDegreesChangeNothing) {
    for (const char* text : {"1", "6", "2,5", "cubic"})
        type(degree, text);
    expectNoStep(before);
}

TEST_F(SplinePropertiesTest, parabolasHaveNeitherRuleNorJoins) {
    selectPoints({1});
    EXPECT_TRUE(join.isEnabled());
    type(degree, "2");
    EXPECT_FALSE(rule.isEnabled());
    EXPECT_FALSE(join.isEnabled());
    document().undo();
    EXPECT_TRUE(rule.isEnabled());
    EXPECT_TRUE(join.isEnabled());
}

TEST_F(SplinePropertiesTest, closesAndOpensInOneStepEach) {
    click(closed);
    expectOneStep("Close the curve", before, withClosed(before, true));
    EXPECT_FALSE(closed.isChecked());
    open({withClosed(before, true)});
    EXPECT_TRUE(closed.isChecked());
    click(closed);
    expectOneStep("Open the curve", withClosed(before, true), before);
}

TEST_F(SplinePropertiesTest, theJoinIsThatOfTheSelectedKnots) {
    EXPECT_FALSE(join.isEnabled());
    selectPoints({1, 3});
    QTest::keyClick(&join, Qt::Key_End);
    const std::vector<int> knots{1, 3};
    expectOneStep("Set the join", before, withJoin(before, knots, SplineKnot::Join::corner));
    EXPECT_EQ(join.currentText(), QStringLiteral("Automatic"));
    EXPECT_EQ(editor().selectedPoints(), knots);
    editor().select({{editor().activeSerial(), {GripKind::outHandle, 2}}});
    EXPECT_TRUE(join.isEnabled()) << "the handle has a knot";
}

TEST_F(SplinePropertiesTest, endDerivativesAreAskedForWhereTheChainIsClamped) {
    for (QWidget* row : {&start, &end})
        EXPECT_FALSE(row->findChild<QCheckBox*>()->isEnabled());
    QTest::keyClick(&rule, Qt::Key_Down);
    for (QWidget* row : {&start, &end})
        EXPECT_TRUE(row->findChild<QCheckBox*>()->isEnabled());
    click(closed);
    for (QWidget* row : {&start, &end})
        EXPECT_FALSE(row->findChild<QCheckBox*>()->isEnabled());
}

TEST_F(SplinePropertiesTest, anEndDerivativeIsGivenAndTakenBackInOneStepEach) {
    const SplineCurve clamped = withRule(before, SplineCurve::Rule::clamped);
    open({clamped});
    const EndDerivatives natural = endDerivatives(clamped, knotHandles(clamped));
    click(*start.findChild<QCheckBox*>());
    const SplineCurve given = withEndDerivatives(clamped, natural.start, {});
    expectOneStep("Change the start derivative", clamped, given);
    click(*end.findChild<QCheckBox*>());
    expectOneStep("Change the end derivative", clamped, withEndDerivatives(clamped, {}, natural.end));
    open({given});
    click(*start.findChild<QCheckBox*>());
    expectOneStep("Change the start derivative", given, clamped);
}

TEST_F(SplinePropertiesTest, aTypedCoordinateOfAnEndDerivativeChangesNoOther) {
    const SplineCurve given =
        withEndDerivatives(withRule(before, SplineCurve::Rule::clamped), Vector{1.0 / 3, 2}, Vector{0.1, 0.7});
    open({given});
    type(named<NumberField>(start, "y"), "2,5");
    expectOneStep("Change the start derivative", given,
                  withEndDerivatives(given, Vector{1.0 / 3, 2.5}, Vector{0.1, 0.7}));
    type(named<NumberField>(end, "x"), "-0.5");
    expectOneStep("Change the end derivative", given, withEndDerivatives(given, Vector{1.0 / 3, 2}, Vector{-0.5, 0.7}));
    type(named<NumberField>(end, "x"), "2e9");
    EXPECT_TRUE(curve() == Curve(given));
}

TEST_F(SplinePropertiesTest, isDisabledInAnEmptySheetAndShowsAHalfDrawnChain) {
    editor().clear();
    EXPECT_FALSE(rule.isEnabled());
    EXPECT_FALSE(closed.isEnabled());
    editor().addPoint({1, 1});
    EXPECT_TRUE(rule.isEnabled());
    QTest::keyClick(&rule, Qt::Key_Down);
    QTest::keyClick(&rule, Qt::Key_Down);
    EXPECT_EQ(value<SplineCurve>().rule, SplineCurve::Rule::clamped);
    EXPECT_EQ(named<NumberField>(start, "x").value(), 0);
    click(closed);
    EXPECT_TRUE(value<SplineCurve>().closed);
}

TEST_F(SplinePropertiesTest, theCombIsScaledWithoutAStep) {
    QSlider& scale = named<QSlider>(properties, "Scale of the comb");
    NumberField& field = named<NumberField>(properties, "Scale of the comb");
    EXPECT_FALSE(scale.isEnabled()); // there is no comb yet
    click(test::saying<QCheckBox>(properties, "Show the comb"));
    EXPECT_TRUE(editor().sheet().view.layers.at("curvature-comb"));
    EXPECT_TRUE(scale.isEnabled());
    type(field, "2.5");
    EXPECT_EQ(numberOf(&editor().sheet().view, kCombScale), 2.5);
    dragHandle(scale, 20);
    EXPECT_GT(numberOf(&editor().sheet().view, kCombScale), 2.5);
    type(field, "0");
    EXPECT_GT(numberOf(&editor().sheet().view, kCombScale), 2.5);
    expectNoStep(before);
    EXPECT_FALSE(document().isModified());
}

TEST_F(SplinePropertiesTest, theBuiltInDrawingIsComparedWithAPolyline) {
    QSlider& perSegment = named<QSlider>(properties, "Points per segment");
    const QLabel& deviation = named<QLabel>(properties, "Largest deviation");
    EXPECT_EQ(deviation.text(), QStringLiteral("–"));
    EXPECT_FALSE(perSegment.isEnabled());
    click(test::saying<QCheckBox>(properties, "Show the polyline"));
    test::settle();
    EXPECT_EQ(deviation.text(), valueText(deviationOf(before, 8), 4));
    type(named<NumberField>(properties, "Points per segment"), "3");
    test::settle();
    EXPECT_EQ(numberOf(&editor().sheet().view, kPolylinePoints), 3);
    EXPECT_EQ(deviation.text(), valueText(deviationOf(before, 3), 4));
    const QPoint knot = test::pixelOf(tab, 2);
    QTest::mousePress(tab.canvas().viewport(), Qt::LeftButton, {}, knot);
    QTest::mouseMove(tab.canvas().viewport(), knot + QPoint(20, 60));
    test::settle();
    EXPECT_EQ(deviation.text(), valueText(deviationOf(value<SplineCurve>(), 3), 4));
    QTest::keyClick(tab.canvas().viewport(), Qt::Key_Escape);
    expectNoStep(before);
}

} // namespace
} // namespace kriva::ui
