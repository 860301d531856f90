#include "core/sheets/spline/editing/chain_edits.h"
#include "core/sheets/spline/editing/handle_edits.h"
#include "core/sheets/spline/editing/joins.h"
#include "tests/support/canvas_hand.h"

#include <QMenuBar>

namespace kriva::ui {
namespace {

using test::GestureTest;
using Join = SplineKnot::Join;

class SplineActions : public GestureTest, public testing::Test {
  protected:
    SplineActions()
        : GestureTest(test::kSpline) {
        SplineCurve curve = spline();
        curve.knots[1] = {{2, 4}, Join::corner, Point{1, 3}, Point{4, 4}};
        curve.knots[2] = {{6, 4}, Join::smooth, Point{4, 5}, Point{7, 3.5}};
        use(curve);
    }
    void selectKnots() {
        click({2, 4});
        click({6, 4}, Qt::ShiftModifier);
    }
    [[nodiscard]] const SplineCurve& old() const { return std::get<SplineCurve>(before); }

    const std::vector<int> knots{1, 2};
};

TEST_F(SplineActions, keysSetTheJoinOfAllSelectedKnots) {
    using KeyOfJoin = std::pair<Qt::Key, Join>;
    for (const auto& [key, join] : {KeyOfJoin(Qt::Key_C, Join::corner), KeyOfJoin(Qt::Key_S, Join::smooth),
                                    KeyOfJoin(Qt::Key_Y, Join::symmetric), KeyOfJoin(Qt::Key_A, Join::automatic)}) {
        selectKnots();
        this->key(key, Qt::ShiftModifier);
        EXPECT_EQ(spline(), withJoin(old(), knots, join));
        expectOneStep("Set the join");
        document().undo();
    }
}

TEST_F(SplineActions, keysGoByThePhysicalKey) {
    selectKnots();
    QKeyEvent cyrillic(QEvent::KeyPress, 0x0421, Qt::ShiftModifier, 54, 0, 0, QStringLiteral("С"));
    QApplication::sendEvent(&canvas, &cyrillic);
    if (QGuiApplication::platformName() != u"xcb")
        return expectNoStep(); // the system does not tell the key
    EXPECT_EQ(knot(2).join, Join::corner);
}

TEST_F(SplineActions, theMenuSaysWhichJoinAllKnotsHave) {
    EXPECT_FALSE(action("corner").isEnabled());
    click({2, 4});
    EXPECT_TRUE(action("corner").isEnabled());
    EXPECT_TRUE(action("corner").isChecked());
    click({6, 4}, Qt::ShiftModifier);
    EXPECT_FALSE(action("corner").isChecked());
    EXPECT_FALSE(action("smooth").isChecked());
    action("symmetric").trigger();
    EXPECT_TRUE(action("symmetric").isChecked());
    action("symmetric").trigger();
    EXPECT_TRUE(action("symmetric").isChecked()) << "it is not switched off";
    EXPECT_EQ(steps().size(), 1);
}

TEST_F(SplineActions, handlesAreAlignedEqualizedPulledOutAndRetracted) {
    const auto expectEdit = [&](const char* name, const SplineCurve& value, const char* step) {
        selectKnots();
        action(name).trigger();
        EXPECT_EQ(spline(), value);
        expectOneStep(step);
        document().undo();
    };
    expectEdit("alignHandles", withHandlesAligned(old(), knots), "Align the handles");
    expectEdit("equalizeHandles", withHandlesEqualized(old(), knots), "Equalize the handles");
    expectEdit("retractHandles", withHandlesRetracted(old(), knots), "Retract the handles");
    use(withHandlesRetracted(old(), knots));
    expectEdit("pullOutHandles", withHandlesPulledOut(old(), knots), "Pull out the handles");
}

TEST_F(SplineActions, aSelectedHandleStandsForItsKnotAndIsRetractedAlone) {
    click({4, 4});
    EXPECT_TRUE(action("corner").isChecked());
    action("retractHandles").trigger();
    EXPECT_EQ(knot(1), (SplineKnot{{2, 4}, Join::corner, Point{1, 3}, Point{2, 4}}));
    expectOneStep("Retract the handles");
}

TEST_F(SplineActions, theChainIsClosedAndOpened) {
    action("closed").trigger();
    EXPECT_EQ(spline(), withClosed(old(), true));
    EXPECT_TRUE(action("closed").isChecked());
    expectOneStep("Close the curve");
    action("closed").trigger();
    EXPECT_FALSE(spline().closed);
    EXPECT_EQ(steps().last(), QStringLiteral("Open the curve"));
}

TEST_F(SplineActions, parabolasHaveNoHandles) {
    use(withDegree(old(), 2));
    click({2, 4});
    for (const char* name : {"corner", "alignHandles", "equalizeHandles", "pullOutHandles", "retractHandles"})
        EXPECT_FALSE(action(name).isEnabled()) << name;
    key(Qt::Key_C, Qt::ShiftModifier);
    expectNoStep();
}

TEST_F(SplineActions, standInTheCurveMenuOfTheSplineTabAlone) {
    const auto curveMenu = [&] {
        for (const QAction* entry : window.window.menuBar()->actions())
            if (entry->text() == QStringLiteral("&Curve"))
                return entry->menu()->actions();
        return QList<QAction*>();
    };
    EXPECT_TRUE(curveMenu().contains(&action("corner")));
    EXPECT_TRUE(curveMenu().contains(&action("raiseNumber")));
    window.shown(test::kCombined);
    EXPECT_FALSE(curveMenu().contains(&action("corner")));
    EXPECT_TRUE(curveMenu().contains(
        window.window.tab(test::kCombined).canvas().findChild<QAction*>(QStringLiteral("raiseNumber"))));
}

TEST_F(SplineActions, followTheLanguage) {
    window.language.setLanguage(Language::Slovenian);
    QApplication::processEvents();
    EXPECT_NE(action("closed").text(), QStringLiteral("Closed"));
    window.language.setLanguage(Language::English);
    QApplication::processEvents();
    EXPECT_EQ(action("closed").text(), QStringLiteral("Closed"));
}

} // namespace
} // namespace kriva::ui
