#include "core/io/svg/svg_writer.h"
#include "core/sheets/combined/combined.h"
#include "tests/support/panel_test.h"
#include "ui/controls/player.h"
#include "ui/figures/caption_text.h"
#include "ui/tabs/properties/properties_panel.h"

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
        : PanelTest(test::kCombined) {}
    [[nodiscard]] CombinedCurve corrected() const {
        CombinedCurve curve = before;
        curve.method = CombinedCurve::Method::pairs;
        curve.corrections = {{0, {0.5, 1}}, {1, {1.5, 2.25}}};
        return curve;
    }
    void selectMiddle(int pair) { editor().select({{editor().activeSerial(), {GripKind::middle, pair}}}); }

    [[nodiscard]] bool isExported(const char* layer) {
        const std::string svg =
            writeSheetSvg(editor().documentOnView(), test::kCombined, textSource(), {.stage = editor().layerStage()});
        return svg.find("<g id=\"layer-" + std::string(layer) + "\"") != std::string::npos;
    }
    [[nodiscard]] bool says(const char* text) {
        for (const QLabel* label : properties.findChildren<QLabel*>())
            if (label->text() == QLatin1String(text))
                return true;
        return false;
    }

    PropertiesPanel& properties = panel<PropertiesPanel>("properties");
    QComboBox& method = named<QComboBox>(properties, "Method");
    QComboBox& basis = named<QComboBox>(properties, "Basis");
    QSlider& slider = named<QSlider>(properties, "Degree");
    NumberField& degree = named<NumberField>(properties, "Degree");
    QPushButton& automatic = *properties.findChild<QPushButton*>();
    Player& player = *properties.findChild<Player*>();
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

TEST_F(CombinedPropertiesTest, thePlayerStepsThroughTheAlgorithm) {
    EXPECT_EQ(player.stage(), kCombinedStages - 1);
    EXPECT_TRUE(says("5 of 5: the whole curve"));
    click(*player.findChild<QToolButton*>(QStringLiteral("back")));
    EXPECT_TRUE(says("4 of 5: joins between the runs"));
    EXPECT_FALSE(isExported("curve"));
    EXPECT_TRUE(isExported("joins"));
    player.setFocus();
    QTest::keyClick(&player, Qt::Key_Left);
    EXPECT_TRUE(isExported("polynomials"));
    EXPECT_FALSE(isExported("joins"));
    QTest::keyClick(&player, Qt::Key_Left);
    EXPECT_TRUE(isExported("run-polygons"));
    QTest::keyClick(&player, Qt::Key_Left);
    EXPECT_TRUE(isExported("points"));
    EXPECT_FALSE(isExported("run-numbers"));
    expectNoStep(before);
    EXPECT_FALSE(document().isModified());
}

TEST_F(CombinedPropertiesTest, theStageIsOnTheCanvasAndStaysWhileAPointIsPulled) {
    const auto canvas = [&] {
        QApplication::processEvents();
        return tab.canvas().viewport()->grab().toImage();
    };
    const QImage whole = canvas();
    QTest::keyClick(&player, Qt::Key_Left);
    QTest::keyClick(&player, Qt::Key_Left);
    EXPECT_NE(canvas(), whole);
    editor().placePoint(1, {0.5, 0.5});
    EXPECT_EQ(editor().layerStage(), 2);
    document().undo();
    EXPECT_EQ(player.stage(), 2);
    QTest::keyClick(&player, Qt::Key_Right);
    QTest::keyClick(&player, Qt::Key_Right);
    EXPECT_EQ(editor().layerStage(), std::nullopt);
    EXPECT_EQ(canvas(), whole);
}

TEST_F(CombinedPropertiesTest, aMiddlePointThatTheStageHidesIsNeitherMarkedNorHit) {
    open({corrected()});
    const auto hit = [&] {
        QApplication::processEvents();
        const QPointF pixel = tab.canvas().mapping().toPixels({0.5, 1});
        QTest::mouseClick(tab.canvas().viewport(), Qt::LeftButton, {}, pixel.toPoint());
        return editor().selection() == Selection{{editor().activeSerial(), {GripKind::middle, 0}}};
    };
    EXPECT_TRUE(hit());
    QTest::keyClick(&player, Qt::Key_Left);
    EXPECT_TRUE(hit());
    QTest::keyClick(&player, Qt::Key_Left);
    EXPECT_FALSE(hit());
}

TEST_F(CombinedPropertiesTest, theStageEndsWithItsCurve) {
    player.tick(); // over and over: from the whole to the points
    EXPECT_EQ(player.stage(), 0);
    editor().newCurve();
    EXPECT_EQ(editor().layerStage(), std::nullopt);
    EXPECT_FALSE(player.isEnabled()); // nothing to step through yet
    editor().addPoint({0, 0});
    EXPECT_TRUE(player.isEnabled());
    EXPECT_EQ(player.stage(), kCombinedStages - 1);
}

TEST_F(CombinedPropertiesTest, aStageCannotBeKept) {
    EXPECT_FALSE(player.findChild<QToolButton*>(QStringLiteral("keep"))->isVisible());
}

} // namespace
} // namespace kriva::ui
