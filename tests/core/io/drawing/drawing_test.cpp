#include "core/document/sheet_figure.h"
#include "core/io/drawing/drawing.h"
#include "tests/support/sheet_curves.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

const TextSource kDrawingTexts{[](Caption caption) { return caption == Caption::curve ? "Curve" : "Word"; },
                               [](double, int) { return std::string(); }, "en"};

Document archAndLine() {
    Document document;
    document.sheets[test::kElevation].curves =
        test::curves({ElevationCurve{"", {{0, 0}, {1, 2}, {3, 2}, {4, 0}}, 2, {}, {}},
                      ElevationCurve{"", {{9, 0}, {9, 5}}, 0, {}, {}}});
    return document;
}

std::vector<std::string_view> layerNames(const Drawing& drawing) {
    std::vector<std::string_view> names;
    for (const Layer& layer : drawing.figure.layers)
        names.push_back(layer.name);
    return names;
}

TEST(Drawing, isTheSheetAsItsViewHasIt) {
    const Document document = archAndLine();
    const Drawing drawing = drawingOf(document, test::kElevation, kDrawingTexts);
    EXPECT_EQ(drawing.figure, figureOf(document.sheets[test::kElevation], 0));
    EXPECT_EQ(drawing.page.width, kPageSide);
    EXPECT_EQ(drawing.layerTitles.size(), drawing.figure.layers.size());
    EXPECT_EQ(drawing.title, "Word");
}

TEST(Drawing, hasTheLayersAskedForAlone) {
    EXPECT_EQ(
        layerNames(drawingOf(archAndLine(), test::kElevation, kDrawingTexts, {.layers = {{"convex-hull", "curve"}}})),
        (std::vector<std::string_view>{"convex-hull", "curve"}));
}

TEST(Drawing, hasTheCurveAskedForAloneAndAsTheActiveOne) {
    const Drawing drawing =
        drawingOf(archAndLine(), test::kElevation, kDrawingTexts, {.layers = {{"curve"}}, .curve = 1});
    ASSERT_EQ(drawing.figure.layers.size(), 1U);
    ASSERT_EQ(drawing.figure.layers[0].strokes.size(), 1U);
    EXPECT_EQ(drawing.figure.layers[0].strokes[0].curve, 1);
}

TEST(Drawing, leavesLabelsOut) {
    for (const Layer& layer :
         drawingOf(archAndLine(), test::kElevation, kDrawingTexts, {.hasLabels = false}).figure.layers)
        EXPECT_TRUE(layer.labels.empty());
}

TEST(Drawing, hasExactlyTheWidthAskedFor) {
    const Drawing drawing = drawingOf(archAndLine(), test::kElevation, kDrawingTexts, {.width = 99.7, .margin = 3});
    EXPECT_EQ(drawing.page.width, 99.7);
    EXPECT_NEAR(onPage(drawing.page, {0, 0}).x, 3, 1e-12);
    EXPECT_NEAR(onPage(drawing.page, {9, 0}).x, 96.7, 1e-12);
    const Drawing upright = drawingOf(archAndLine(), test::kElevation, kDrawingTexts, {.width = 50, .curve = 1});
    EXPECT_EQ(upright.page.width, 50);
    EXPECT_NEAR(onPage(upright.page, {9, 1}).x, 25, 1e-12) << "what has no width stands in the middle";
}

Document raisedArch() {
    Document document;
    document.sheets[test::kElevation].curves =
        test::curves({ElevationCurve{"", {{0, 0}, {1, 2}, {3, 2}, {4, 0}}, 3, {}, {}}});
    return document;
}

TEST(Frames, haveOnePageAndTheirStages) {
    const std::vector<FramePlace> places{{FramePlace::Over::stage, 0}, {FramePlace::Over::stage, 7}};
    const Document document = raisedArch();
    WorkBudget budget;
    const auto frames = framesOf(document, test::kElevation, places, kDrawingTexts, {}, budget);
    ASSERT_TRUE(frames);
    ASSERT_EQ(frames->size(), 2U);
    EXPECT_EQ((*frames)[0].page.width, (*frames)[1].page.width);
    Document last = document;
    std::get<ElevationCurve>(last.sheets[test::kElevation].curves[0]).times = 7;
    EXPECT_EQ((*frames)[1].figure, drawingOf(last, test::kElevation, kDrawingTexts).figure);
    const auto strip = frameStripOf(document, test::kElevation, places, kDrawingTexts, {.width = 200}, budget);
    ASSERT_TRUE(strip);
    EXPECT_EQ(strip->page.width, 200);
    EXPECT_GT(boxOf(strip->figure).width(), 2 * boxOf((*frames)[0].figure).width());
    // The same layers as one frame has, each with what both have.
    for (const Layer& layer : strip->figure.layers) {
        if (layer.name == "curve") {
            EXPECT_EQ(layer.strokes.size(), 2U);
        }
    }
}

TEST(DrawingOfPlots, hasTheSizeLayersAndTitlesAskedFor) {
    Plot plot;
    plot.lines = {{polyline(Points{{0, 0}, {1, 1}})}};
    const Drawing usual = drawingOf({&plot, 1}, kDrawingTexts, {.margin = 0});
    EXPECT_EQ(usual.page.width, 120);
    EXPECT_EQ(usual.page.height, 75);
    EXPECT_EQ(usual.layerTitles.size(), usual.figure.layers.size());
    const Drawing small = drawingOf({&plot, 1}, kDrawingTexts, {.width = 86, .margin = 3, .layers = {{"plot-lines"}}});
    EXPECT_EQ(small.page.width, 86);
    EXPECT_EQ(small.page.height, 56);
    ASSERT_EQ(small.figure.layers.size(), 1U);
    EXPECT_EQ(small.figure.layers[0].name, "plot-lines");
    EXPECT_EQ(small.layerTitles.size(), 1U);
    for (const Stroke& stroke : small.figure.layers[0].strokes)
        for (const Point p : stroke.path.points) {
            EXPECT_GE(onPage(small.page, p).x, 3);
            EXPECT_LE(onPage(small.page, p).x, 83);
        }
}

TEST(Frames, areOnlyThoseThatTheCurveHas) {
    const auto has = [](const Document& document, SheetIndex sheet, FramePlace place) {
        WorkBudget budget;
        return framesOf(document, sheet, {&place, 1}, kDrawingTexts, {}, budget).has_value();
    };
    using enum FramePlace::Over;
    Document document = raisedArch();
    document.sheets[test::kSubdivision].curves =
        test::curves({SubdivisionCurve{"", {{0, 0}, {1, 2}, {3, 2}}, {1, 1, 1}, 0.5, 1, {}, {}, {}}});
    document.sheets[test::kSpline].curves = test::curves({SplineCurve{}});
    document.sheets[test::kCombined].curves =
        test::curves({CombinedCurve{"", {{0, 0}, {1, 2}}, {}, 3, {}, {}, {}, {}}});
    EXPECT_TRUE(has(document, test::kElevation, {stage, 10'000}));
    EXPECT_FALSE(has(document, test::kElevation, {stage, 10'001}));
    EXPECT_FALSE(has(document, test::kElevation, {t, 0.5}));
    EXPECT_TRUE(has(document, test::kSubdivision, {stage, 4}));
    EXPECT_FALSE(has(document, test::kSubdivision, {stage, 17}));
    EXPECT_TRUE(has(document, test::kSubdivision, {t, 0.25}));
    EXPECT_FALSE(has(document, test::kSubdivision, {t, 1}));
    EXPECT_FALSE(has(document, test::kSpline, {stage, 0}));
    EXPECT_TRUE(has(document, test::kCombined, {stage, 1}));
    EXPECT_TRUE(has(document, test::kCombined, {stage, 5}));
    EXPECT_FALSE(has(document, test::kCombined, {stage, 0}));
    EXPECT_FALSE(has(document, test::kCombined, {stage, 6}));
    EXPECT_FALSE(has({}, test::kElevation, {stage, 0}));
}

} // namespace
} // namespace kriva
