#include "core/bezier/evaluate.h"
#include "core/sheets/elevation/elevation.h"
#include "tests/support/panel_test.h"
#include "ui/panels/plots/plots_panel.h"
#include "ui/panels/result_text.h"

#include <QSignalSpy>
#include <QWheelEvent>

namespace kriva::ui {
namespace {

class PlotsPanelTest : public test::PanelTest {
  protected:
    explicit PlotsPanelTest(SheetIndex sheet = 1)
        : PanelTest(sheet) {
        test::settle();
    }
    [[nodiscard]] std::vector<PlotView*> views() {
        std::vector<PlotView*> visible;
        for (PlotView* view : panel_.findChildren<PlotView*>())
            if (view->isVisible())
                visible.push_back(view);
        return visible;
    }
    [[nodiscard]] QStringList valueTexts() {
        QStringList texts;
        for (const QLabel* label : panel_.findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(QLatin1Char('=')))
                texts.append(label->text());
        return texts;
    }
    void choose(int plot) {
        panel_.findChild<QComboBox*>()->setCurrentIndex(plot);
        test::settle();
    }
    static void wheel(PlotView& view, QPointF at, int notches) {
        QWheelEvent event(at, view.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view, &event);
    }

    PlotsPanel& panel_ = panel<PlotsPanel>("plots");
};

class PlotsInEachTab : public PlotsPanelTest, public testing::WithParamInterface<SheetIndex> {
  protected:
    PlotsInEachTab()
        : PlotsPanelTest(GetParam()) {}
    [[nodiscard]] std::vector<PlotGroup> plotsNow() {
        return withoutLimit([this](WorkBudget& budget) { return plotsOf(curve(), budget); });
    }
};

TEST_P(PlotsInEachTab, areThoseOfTheActiveCurveAndFollowADrag) {
    test::settle();
    const std::vector<PlotGroup> before = plotsNow();
    ASSERT_FALSE(before.empty());
    for (std::size_t group = 0; group < before.size(); ++group) {
        choose(static_cast<int>(group));
        ASSERT_EQ(views().size(), before[group].plots.size());
        for (std::size_t i = 0; i < views().size(); ++i)
            EXPECT_EQ(views()[i]->plot(), before[group].plots[i]);
    }
    QTest::mousePress(tab.canvas().viewport(), Qt::LeftButton, {}, test::pixelOf(tab, 1));
    QTest::mouseMove(tab.canvas().viewport(), test::pixelOf(tab, 1) + QPoint(9, 31));
    QTest::mouseRelease(tab.canvas().viewport(), Qt::LeftButton, {}, test::pixelOf(tab, 1));
    test::settle();
    const std::vector<PlotGroup> after = plotsNow();
    EXPECT_EQ(views().front()->plot(), after.back().plots.front());
}

INSTANTIATE_TEST_SUITE_P(Tabs, PlotsInEachTab, testing::Range<SheetIndex>(0, kSheetCount));

TEST_F(PlotsPanelTest, tellTheWeightsAtTAndUnderTheCrosshair) {
    SubdivisionCurve cubic;
    cubic.points = {{0, 0}, {0, 2}, {8, 2}, {4, 0}};
    cubic.multiplicity.assign(4, 1);
    open({cubic});
    test::settle();
    ASSERT_EQ(valueTexts().size(), 1);
    EXPECT_EQ(valueTexts().front(),
              QStringLiteral("<i>t</i> = 0.5: <i>B</i><sub>0</sub> = 0.125; <i>B</i><sub>1</sub> = "
                             "0.375; <i>B</i><sub>2</sub> = 0.375; <i>B</i><sub>3</sub> = 0.125"));
    PlotView& view = *views().front();
    QTest::mouseMove(&view, view.rect().center());
    ASSERT_TRUE(view.crosshair());
    EXPECT_NE(*view.crosshair(), 0.5);
    const double weight = bernstein(3, *view.crosshair())[1];
    EXPECT_TRUE(valueTexts().front().contains(QString::number(weight, 'g', 6))) << qPrintable(valueTexts().front());
    view.setFocus();
    const double there = *view.crosshair();
    QTest::keyClick(&view, Qt::Key_Right);
    EXPECT_NEAR(*view.crosshair(), there + 0.01, 1e-12);
    EXPECT_EQ(steps(), QStringList()); // looking changes nothing
}

TEST_F(PlotsPanelTest, zoomAlongXAndShowAllAgain) {
    PlotView& view = *views().front();
    const PlotAxis all = view.shownPlot().x;
    const QPointF at = view.rect().center();
    wheel(view, at, 5);
    const PlotAxis part = view.shownPlot().x;
    EXPECT_GT(part.low, all.low);
    EXPECT_LT(part.high, all.high);
    QTest::mousePress(&view, Qt::LeftButton, {}, at.toPoint());
    QTest::mouseMove(&view, at.toPoint() - QPoint(10, 0));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at.toPoint() - QPoint(10, 0));
    EXPECT_GT(view.shownPlot().x.low, part.low);
    EXPECT_NEAR(view.shownPlot().x.high - view.shownPlot().x.low, part.high - part.low, 1e-12);
    QTest::mouseDClick(&view, Qt::LeftButton, {}, at.toPoint());
    EXPECT_EQ(view.shownPlot().x, all);
}

class SplinePlotsTest : public PlotsPanelTest {
  protected:
    SplinePlotsTest()
        : PlotsPanelTest(2) {}
};

TEST_F(SplinePlotsTest, zoomAlongBothAxesWhereTheyAreToScale) {
    test::settle();
    PlotView& view = *views().front();
    ASSERT_TRUE(view.plot().isToScale) << "the hodograph";
    const Plot all = view.shownPlot();
    const QPoint at = view.rect().center();
    QTest::mouseMove(&view, at);
    ASSERT_TRUE(view.pointedAt());
    EXPECT_FALSE(view.crosshair());
    const Point place = *view.pointedAt();
    ASSERT_EQ(valueTexts().size(), 1);
    EXPECT_TRUE(valueTexts().front().contains(valueText(place.x, 6)));
    wheel(view, at, 5);
    const Plot part = view.shownPlot();
    EXPECT_LT(part.x.high - part.x.low, all.x.high - all.x.low);
    EXPECT_NEAR((part.y.high - part.y.low) / (part.x.high - part.x.low),
                (all.y.high - all.y.low) / (all.x.high - all.x.low), 1e-9);
    QTest::mouseMove(&view, at + QPoint(1, 0));
    QTest::mouseMove(&view, at);
    EXPECT_LT(distance(*view.pointedAt(), place), 1e-9 * (all.x.high - all.x.low)) << "what is under it stays there";
    QTest::mouseDClick(&view, Qt::LeftButton, {}, at);
    EXPECT_EQ(view.shownPlot(), all);
}

class ElevationPlotsTest : public PlotsPanelTest {
  protected:
    ElevationPlotsTest()
        : PlotsPanelTest(0) {}
};

TEST_F(ElevationPlotsTest, lookAtWholeDegreesAndZoomOnLogarithmicAxesToo) {
    test::settle();
    choose(1);
    PlotView& view = *views().front();
    const PlotAxis all = view.shownPlot().x;
    QTest::mouseMove(&view, view.rect().center());
    ASSERT_TRUE(view.crosshair());
    const double degree = *view.crosshair();
    EXPECT_EQ(degree, std::round(degree));
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_Right);
    EXPECT_GT(*view.crosshair(), degree);
    EXPECT_EQ(*view.crosshair(), std::round(*view.crosshair()));
    QTest::keyClick(&view, Qt::Key_Left);
    EXPECT_EQ(*view.crosshair(), degree);
    wheel(view, view.rect().center(), 5);
    EXPECT_GT(view.shownPlot().x.low, all.low);
    EXPECT_LT(view.shownPlot().x.high, all.high);
    wheel(view, view.rect().center(), -9);
    EXPECT_EQ(view.shownPlot().x, all);
}

TEST_F(PlotsPanelTest, areAskedForTheFileOfWhatIsOnView) {
    QSignalSpy asked(&panel_, &PlotsPanel::exportRequested);
    panel_.disconnect(&tab);
    test::click(test::named<QToolButton>(panel_, "Export the plot"));
    ASSERT_EQ(asked.size(), 1);
    EXPECT_EQ(asked[0][0].value<std::vector<Plot>>().size(), views().size());
}

class CombinedPlotsTest : public PlotsPanelTest {
  protected:
    CombinedPlotsTest()
        : PlotsPanelTest(3) {}
};

TEST_F(CombinedPlotsTest, shareOneCrosshair) {
    ASSERT_EQ(views().size(), 2U);
    PlotView& above = *views()[0];
    QTest::mouseMove(&above, above.rect().center());
    ASSERT_TRUE(above.crosshair());
    EXPECT_EQ(views()[1]->crosshair(), above.crosshair());
    EXPECT_EQ(valueTexts().size(), 2);
}

} // namespace
} // namespace kriva::ui
