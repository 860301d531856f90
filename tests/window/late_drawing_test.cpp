#include "core/document/sheet_figure.h"
#include "tests/support/sheet_curves.h"
#include "tests/support/test_window.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace kriva {
namespace {

constexpr SheetIndex kCombined = kSheetOf<CombinedCurve>;
const ui::StepLabel kStep{"Move"};

/// A run for each point: a frame has no time for so many.
CombinedCurve zigzag(int points) {
    CombinedCurve curve;
    for (int i = 0; i < points; ++i)
        curve.points.push_back({static_cast<double>(i % 2), static_cast<double>(i)});
    return curve;
}

Document documentWith(const std::vector<test::AnyCurve>& curves) {
    Document document;
    document.active = kCombined;
    document.sheets[kCombined].curves.assign(curves.begin(), curves.end());
    return document;
}

class LateDrawingTest : public testing::Test {
  protected:
    void open(const std::vector<test::AnyCurve>& curves) {
        shell.window.session().show(documentWith(curves));
        canvas = &shell.window.tab(kCombined).canvas();
    }
    [[nodiscard]] ui::Serial serial(std::size_t curve) { return shell.window.document().serials(kCombined)[curve]; }
    [[nodiscard]] ui::HitTarget shownOf(ui::Serial serial) {
        for (const ui::HitTarget& target : canvas->scene().curves().targets())
            if (target.serial == serial)
                return target;
        return {};
    }
    /// Whether the canvas shows what the curve is now.
    void expectUpToDate(std::size_t curve) {
        const Sheet& sheet = shell.window.document().sheet(kCombined);
        WorkBudget unlimited;
        const auto drawnNow = drawn(sheet.curves[curve], contextOf(sheet, static_cast<int>(curve)), unlimited);
        const ui::HitTarget shown = shownOf(serial(curve));
        EXPECT_TRUE(std::ranges::equal(shown.grips, drawnNow->grips));
        EXPECT_TRUE(std::ranges::equal(shown.layers, drawnNow->figure.layers));
    }
    void put(std::size_t curve, test::AnyCurve value) {
        shell.window.document().change(kCombined, serial(curve), std::move(value), kStep);
    }

    test::TestWindow shell;
    ui::CanvasView* canvas = nullptr;
};

TEST_F(LateDrawingTest, theFirstPictureHasThePointsAndTheRestFollows) {
    open({zigzag(8'000)});
    const ui::HitTarget first = shownOf(serial(0));
    ASSERT_EQ(first.layers.size(), 1u);
    EXPECT_EQ(first.layers.front().marks.front().at, zigzag(8'000).points);
    EXPECT_EQ(first.grips.size(), 8'000u);
    test::settle();
    expectUpToDate(0);
}

TEST_F(LateDrawingTest, whatAFrameHasTimeForIsThereAtOnce) {
    open({zigzag(800)});
    expectUpToDate(0);
}

TEST_F(LateDrawingTest, manySmallCurvesAreDrawnLateToo) {
    open(std::vector<test::AnyCurve>(20, zigzag(800)));
    EXPECT_EQ(shownOf(serial(7)).layers.size(), 1u);
    test::settle();
    for (std::size_t curve = 0; curve < 20; ++curve)
        expectUpToDate(curve);
}

TEST_F(LateDrawingTest, theLastValueIsShownHoweverManyCameWhileOneWasDrawn) {
    open({zigzag(8'000), zigzag(3)});
    for (int change = 1; change <= 5; ++change) {
        CombinedCurve changed = zigzag(8'000 - change);
        changed.points.front() = {-1.0 * change, -1};
        put(0, changed);
        EXPECT_EQ(shownOf(serial(0)).grips.size(), 8'000u - static_cast<std::size_t>(change));
    }
    put(1, zigzag(4)); // a small one while the large one is drawn
    test::settle();
    expectUpToDate(0);
    expectUpToDate(1);
}

TEST_F(LateDrawingTest, whatIsShownStaysUntilTheNextIsDrawn) {
    open({zigzag(8'000)});
    test::settle();
    const std::size_t layers = shownOf(serial(0)).layers.size();
    ASSERT_GT(layers, 1u);
    put(0, zigzag(8'001));
    EXPECT_EQ(shownOf(serial(0)).layers.size(), layers);
    shell.window.document().setLayerShown(kCombined, "joins", false);
    EXPECT_EQ(shownOf(serial(0)).layers.size(), layers);
    test::settle();
    EXPECT_EQ(shownOf(serial(0)).layers.size(), layers - 1);
    expectUpToDate(0);
}

TEST_F(LateDrawingTest, curvesThatGoAreNotDrawnAnyMore) {
    open({zigzag(8'000), zigzag(8'001), zigzag(8'002)});
    const ui::Serial gone = serial(1);
    shell.window.document().remove(kCombined, gone, kStep);
    EXPECT_EQ(shownOf(gone).serial, 0u);
    test::settle();
    EXPECT_EQ(shownOf(gone).serial, 0u);
    expectUpToDate(0);
    expectUpToDate(1);
}

TEST_F(LateDrawingTest, anotherDocumentIsNotOvertakenByTheOneBefore) {
    open({zigzag(9'000)});
    open({zigzag(8'000)});
    test::settle();
    expectUpToDate(0);
    open({zigzag(5)});
    test::settle();
    expectUpToDate(0);
}

TEST_F(LateDrawingTest, allIsFittedOnceAllIsDrawn) {
    open({zigzag(8'000)});
    test::settle();
    const ui::Viewport shown = canvas->mapping();
    canvas->fitAll();
    EXPECT_EQ(canvas->mapping(), shown);
}

TEST_F(LateDrawingTest, whatSomebodySetMeanwhileIsKept) {
    open({zigzag(8'000)});
    canvas->zoomIn();
    const Point middle = canvas->mapping().toDocument(canvas->viewport()->rect().center());
    const double pixels = canvas->mapping().scale;
    test::settle();
    EXPECT_NEAR(canvas->mapping().scale, pixels, 1e-9 * pixels);
    EXPECT_LT(distance(canvas->mapping().toDocument(canvas->viewport()->rect().center()), middle), 1e-6);
}

} // namespace
} // namespace kriva
