#include "tests/support/panel_test.h"
#include "ui/canvas/base/grid.h"
#include "ui/canvas/rulers/ruler.h"

namespace kriva::ui {
namespace {

class RulersTest : public test::PanelTest {
  protected:
    RulersTest()
        : PanelTest(test::kElevation) {}
    ~RulersTest() override {
        if (above.isVisible())
            toggle();
    }
    void toggle() {
        QTest::keyClick(&tab.canvas(), Qt::Key_R, Qt::ControlModifier);
        QApplication::processEvents();
    }
    /// The longest run of ink across the ruler above at each of its pixels.
    [[nodiscard]] bool hasLongTick(double coordinate) {
        const QImage picture = above.grab().toImage();
        const int x = static_cast<int>(std::floor(tab.canvas().mapping().toPixels({coordinate, 0}).x()));
        const QColor paper = above.palette().color(QPalette::Base);
        for (int y = 0; y < picture.height(); ++y)
            if (picture.pixelColor(x, y) == paper)
                return false;
        return true;
    }

    Ruler& above = *tab.findChild<Ruler*>(QStringLiteral("rulerAbove"));
    Ruler& atLeft = *tab.findChild<Ruler*>(QStringLiteral("rulerAtLeft"));
};

TEST_F(RulersTest, areShownByTheirKeyInAllTabsAndRemembered) {
    EXPECT_FALSE(above.isVisible());
    toggle();
    EXPECT_TRUE(above.isVisible());
    EXPECT_TRUE(atLeft.isVisible());
    EXPECT_TRUE(Preferences().areRulersShown());
    EXPECT_TRUE(shell.shown(test::kSubdivision).findChild<Ruler*>(QStringLiteral("rulerAbove"))->isVisible());
    shell.shown(test::kElevation);
    toggle();
    EXPECT_FALSE(above.isVisible());
    EXPECT_FALSE(Preferences().areRulersShown());
}

TEST_F(RulersTest, lieAlongTheCanvas) {
    toggle();
    const QRect canvas(tab.canvas().mapTo(&tab, QPoint()), tab.canvas().size());
    EXPECT_EQ(above.mapTo(&tab, QPoint(0, above.height())), canvas.topLeft());
    EXPECT_EQ(above.width(), canvas.width());
    EXPECT_EQ(atLeft.mapTo(&tab, QPoint(atLeft.width(), 0)), canvas.topLeft());
    EXPECT_EQ(atLeft.height(), canvas.height());
}

TEST_F(RulersTest, haveLongTicksWhereTheGridHasNumbersAtEveryZoom) {
    toggle();
    for (int i = 0; i < 6; ++i) {
        const Viewport& mapping = tab.canvas().mapping();
        const double tick = nearestMultiple(numberStep(mapping), mapping.centre.x);
        EXPECT_TRUE(hasLongTick(tick)) << tick;
        EXPECT_FALSE(hasLongTick(tick + gridStep(mapping))) << "a short one";
        tab.canvas().zoomIn();
        QApplication::processEvents();
    }
}

TEST_F(RulersTest, aMarkFollowsThePointer) {
    toggle();
    QTest::mouseMove(tab.canvas().viewport(), {70, 90});
    ASSERT_TRUE(above.pointer());
    EXPECT_EQ(above.pointer()->x(), 70);
    EXPECT_EQ(atLeft.pointer()->y(), 90);
    const QColor accent = above.palette().color(QPalette::Highlight);
    EXPECT_EQ(above.grab().toImage().pixelColor(70, 2), accent);
    EXPECT_EQ(atLeft.grab().toImage().pixelColor(2, 90), accent);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(tab.canvas().viewport(), &leave);
    EXPECT_FALSE(above.pointer());
    EXPECT_NE(above.grab().toImage().pixelColor(70, 2), accent);
}

TEST_F(RulersTest, followTheTheme) {
    toggle();
    shell.theme.setTheme(ThemeChoice::Dark);
    QApplication::processEvents();
    EXPECT_LT(above.grab().toImage().pixelColor(1, above.height() - 3).lightness(), 100);
    shell.theme.setTheme(ThemeChoice::Light);
    QApplication::processEvents();
    EXPECT_GT(above.grab().toImage().pixelColor(1, above.height() - 3).lightness(), 150);
}

} // namespace
} // namespace kriva::ui
