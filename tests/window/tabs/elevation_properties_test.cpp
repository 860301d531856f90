#include "core/sheets/elevation/elevation.h"
#include "tests/support/panel_test.h"
#include "ui/controls/player.h"
#include "ui/panels/layers_panel.h"
#include "ui/panels/result_text.h"
#include "ui/tabs/properties/properties_panel.h"

namespace kriva::ui {
namespace {

using test::click;
using test::dragHandle;
using test::named;
using test::type;

class ElevationPropertiesTest : public test::PanelTest {
  protected:
    ElevationPropertiesTest()
        : PanelTest(test::kElevation) {}
    static ElevationCurve with(ElevationCurve curve, int times) {
        curve.times = times;
        return curve;
    }
    [[nodiscard]] QPushButton& buttonSaying(const char* text) { return test::saying<QPushButton>(properties, text); }
    [[nodiscard]] bool hasLabel(const QString& text) {
        const QList<QLabel*> labels = properties.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) { return label->text() == text; });
    }
    [[nodiscard]] QToolButton& button(const char* name) {
        return *player.findChild<QToolButton*>(QString::fromLatin1(name));
    }

    PropertiesPanel& properties = panel<PropertiesPanel>("properties");
    QSlider& slider = named<QSlider>(properties, "Degree");
    NumberField& field = named<NumberField>(properties, "Degree");
    Player& player = *properties.findChild<Player*>();
    const ElevationCurve before = value<ElevationCurve>(); // a cubic raised five times
};

TEST_F(ElevationPropertiesTest, aDragOfTheSliderIsOneStep) {
    dragHandle(slider, 30);
    const int times = slider.value();
    EXPECT_GT(times, 5);
    expectOneStep("Raise the degree", before, with(before, times));
    EXPECT_EQ(slider.value(), 5);
    EXPECT_EQ(field.value(), 8);
}

TEST_F(ElevationPropertiesTest, clicksOnTheButtonsAreOneStepInABurst) {
    QToolButton& more = named<QToolButton>(*slider.parentWidget(), "More");
    for (int i = 0; i < 4; ++i)
        click(more);
    click(named<QToolButton>(*slider.parentWidget(), "Less"));
    EXPECT_EQ(field.value(), 11);
    expectOneStep("Raise the degree", before, with(before, 8));
}

TEST_F(ElevationPropertiesTest, aTypedDegreeIsOneStep) {
    type(field, "20");
    expectOneStep("Raise the degree", before, with(before, 17));
    EXPECT_EQ(field.text(), QStringLiteral("8"));
}

TEST_F(ElevationPropertiesTest, refusedNumbersChangeNothing) {
    for (const char* text : {"2", "10004", "8,5", "", "many"}) {
        type(field, text);
        expectNoStep(before);
        EXPECT_FALSE(field.accessibleDescription().isEmpty()) << text;
    }
    QTest::keyClick(&field, Qt::Key_Escape);
    EXPECT_EQ(field.text(), QStringLiteral("8"));
}

TEST_F(ElevationPropertiesTest, whatTheSheetHasNoRoomForIsNotShownEither) {
    std::vector<test::AnyCurve> curves(200, with(before, 10'000)); // 10,004 points each, 2,000,000 in all
    curves[0] = before;
    open(curves);
    type(field, "10003");
    expectNoStep(before);
    EXPECT_EQ(field.text(), QStringLiteral("8"));
}

TEST_F(ElevationPropertiesTest, theHandleStaysUnderThePointerOfAManyTimesRaisedCurve) {
    open({with(before, 400)});
    const QPoint start = test::handleOf(slider);
    QTest::mousePress(&slider, Qt::LeftButton, {}, start);
    for (int x = 1; x <= 10; ++x)
        QTest::mouseMove(&slider, start - QPoint(x, 0));
    EXPECT_NEAR(test::handleOf(slider).x(), start.x() - 10, 2);
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, start - QPoint(10, 0));
    EXPECT_EQ(steps().size(), 1);
}

TEST_F(ElevationPropertiesTest, isDisabledInAnEmptySheetAndForOnePoint) {
    editor().clear();
    EXPECT_FALSE(field.isEnabled());
    editor().addPoint({1, 1});
    EXPECT_FALSE(field.isEnabled());
    editor().addPoint({2, 1});
    EXPECT_TRUE(field.isEnabled());
    EXPECT_EQ(field.value(), 1);
}

TEST_F(ElevationPropertiesTest, theAnimationStopsWhereItsCurveGoes) {
    click(button("play"));
    EXPECT_TRUE(player.isPlaying());
    editor().clear();
    EXPECT_FALSE(player.isPlaying());
    document().undo();
    click(button("play"));
    shell.window.session().show({});
    EXPECT_FALSE(player.isPlaying());
}

TEST_F(ElevationPropertiesTest, aChangeTakesTheStageOffTheCanvas) {
    player.tick();
    ASSERT_TRUE(editor().hasStage());
    editor().placePoint(1, {2, 2});
    EXPECT_FALSE(editor().hasStage());
    player.tick();
    dragHandle(slider, 20);
    EXPECT_FALSE(editor().hasStage());
    EXPECT_EQ(player.stage(), slider.value());
}

TEST_F(ElevationPropertiesTest, theStageStaysWhereALayerGoes) {
    player.tick();
    const Curve stage = *editor().shown(editor().activeSerial());
    document().setLayerShown(test::kElevation, "control-polygon", false);
    EXPECT_TRUE(editor().hasStage());
    EXPECT_EQ(player.stage(), 6);
    EXPECT_TRUE(*editor().shown(editor().activeSerial()) == stage);
    expectNoStep(before);
}

TEST_F(ElevationPropertiesTest, keysPlayAndStep) {
    player.setFocus();
    QTest::keyClick(&player, Qt::Key_Right);
    EXPECT_EQ(player.stage(), 6);
    QTest::keyClick(&player, Qt::Key_Left);
    EXPECT_EQ(player.stage(), 5);
    QTest::keyClick(&player, Qt::Key_Space);
    EXPECT_TRUE(player.isPlaying());
    QTest::keyClick(player.findChild<QSlider*>(QStringLiteral("scrubber")), Qt::Key_Space);
    EXPECT_FALSE(player.isPlaying());
    expectNoStep(before);
}

TEST_F(ElevationPropertiesTest, theElevatedPolygonOnViewIsTakenOver) {
    QPushButton& take = buttonSaying("Make this the control polygon");
    click(take);
    expectOneStep("Take the elevated polygon over", before, withElevatedPolygon(before));
    player.tick(); // the next stage
    const auto stage = std::get<ElevationCurve>(*editor().shown(editor().activeSerial()));
    ASSERT_NE(stage.times, before.times);
    click(take);
    EXPECT_FALSE(editor().hasStage());
    expectOneStep("Take the elevated polygon over", before, withElevatedPolygon(stage));
    type(field, "3");
    EXPECT_FALSE(take.isEnabled()) << "nothing is elevated";
}

TEST_F(ElevationPropertiesTest, theDeviationIsToldBeforeTheDegreeFalls) {
    QPushButton& reduce = buttonSaying("Reduce the degree by one");
    const Refitted<ElevationCurve> reduced = *withDegreeReduced(before);
    const QString told = QStringLiteral("The curve then moves by at most ") + valueText(*reduced.deviation, 4);
    EXPECT_TRUE(hasLabel(told)) << told.toStdString();
    EXPECT_TRUE(hasLabel(QStringLiteral("N = 8")));
    click(reduce);
    expectOneStep("Reduce the degree", before, reduced.edited.curve);
    click(reduce);
    click(reduce);
    EXPECT_EQ(value<ElevationCurve>().points.size(), 2u);
    EXPECT_FALSE(reduce.isEnabled());
    EXPECT_TRUE(hasLabel(QStringLiteral("The degree cannot fall any more")));
    shell.language.setLanguage(Language::Ukrainian);
    QApplication::sendPostedEvents();
    EXPECT_TRUE(hasLabel(QStringLiteral("Степінь більше не можна знизити")));
}

} // namespace
} // namespace kriva::ui
