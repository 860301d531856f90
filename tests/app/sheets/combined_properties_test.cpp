#include "tests/support/panel_test.h"
#include "ui/sheets/properties_panel.h"

#include <QPushButton>

namespace kriva::ui {
namespace {

using test::click;
using test::dragHandle;
using test::named;
using test::type;

class CombinedPropertiesTest : public test::PanelTest {
  protected:
    CombinedPropertiesTest()
        : PanelTest(3) {}
    [[nodiscard]] CombinedCurve corrected() const {
        CombinedCurve curve = before;
        curve.method = CombinedCurve::Method::pairs;
        curve.corrections = {{0, {0.5, 1}}, {1, {1.5, 2.25}}};
        return curve;
    }
    void selectMiddle(int pair) { editor().select({{editor().activeSerial(), {GripKind::middle, pair}}}); }

    PropertiesPanel& properties = panel<PropertiesPanel>();
    QComboBox& method = named<QComboBox>(properties, "Method");
    QComboBox& basis = named<QComboBox>(properties, "Basis");
    QSlider& slider = named<QSlider>(properties, "Degree");
    NumberField& degree = named<NumberField>(properties, "Degree");
    QPushButton& automatic = *properties.findChild<QPushButton*>();
    const CombinedCurve before = value<CombinedCurve>(); // approximated by cubics
};

TEST_F(CombinedPropertiesTest, theMethodIsSetInOneStep) {
    QTest::keyClick(&method, Qt::Key_Down);
    EXPECT_FALSE(degree.isEnabled());
    CombinedCurve after = before;
    after.method = CombinedCurve::Method::interpolation;
    expectOneStep("Set the method", before, after);
    EXPECT_TRUE(degree.isEnabled());
    EXPECT_EQ(method.currentText(), QStringLiteral("Approximation"));
}

TEST_F(CombinedPropertiesTest, theBasisIsSetInOneStep) {
    QTest::keyClick(&basis, Qt::Key_End);
    CombinedCurve after = before;
    after.basis = CombinedCurve::Basis::chebyshev;
    expectOneStep("Set the basis", before, after);
    EXPECT_EQ(basis.currentIndex(), 0);
}

TEST_F(CombinedPropertiesTest, theDegreeIsSetInOneStepByHandleButtonsOrTyping) {
    CombinedCurve after = before;
    after.degree = 9;
    dragHandle(slider, slider.width());
    expectOneStep("Set the degree", before, after);
    type(degree, "9");
    expectOneStep("Set the degree", before, after);
    after.degree = 1;
    for (int i = 0; i < 3; ++i) // the third finds the button disabled
        click(named<QToolButton>(*slider.parentWidget(), "Less"));
    expectOneStep("Set the degree", before, after);
    EXPECT_EQ(slider.value(), 2);
}

TEST_F(CombinedPropertiesTest, refusedDegreesChangeNothing) {
    for (const char* text : {"0", "10", "1.5"})
        type(degree, text);
    expectNoStep(before);
}

TEST_F(CombinedPropertiesTest, allCorrectionsGoInOneStepWhereNoneIsSelected) {
    EXPECT_FALSE(automatic.isEnabled());
    open({corrected()});
    click(automatic);
    CombinedCurve after = corrected();
    after.corrections.clear();
    EXPECT_FALSE(automatic.isEnabled());
    expectOneStep("Back to automatic", corrected(), after);
    EXPECT_TRUE(automatic.isEnabled());
}

TEST_F(CombinedPropertiesTest, onlyTheSelectedCorrectionsGo) {
    open({corrected()});
    selectMiddle(1);
    click(automatic);
    CombinedCurve after = corrected();
    after.corrections.erase(1);
    expectOneStep("Back to automatic", corrected(), after);
    selectMiddle(2); // it has no correction, and the others are not meant
    click(automatic);
    EXPECT_TRUE(curve() == Curve(corrected()));
}

TEST_F(CombinedPropertiesTest, isDisabledInAnEmptySheet) {
    editor().clear();
    EXPECT_FALSE(method.isEnabled());
    EXPECT_FALSE(degree.isEnabled());
    document().undo();
    EXPECT_TRUE(method.isEnabled());
    EXPECT_TRUE(degree.isEnabled());
}

} // namespace
} // namespace kriva::ui
