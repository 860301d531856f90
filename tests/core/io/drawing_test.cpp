#include "core/io/drawing.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

const TextSource kDrawingTexts{[](Caption caption) { return caption == Caption::curve ? "Curve" : "Word"; },
                               [](double, int) { return std::string(); }, "en"};

Document archAndLine() {
    Document document;
    document.sheets[0].curves = {ElevationCurve{"", {{0, 0}, {1, 2}, {3, 2}, {4, 0}}, 2, {}, {}},
                                 ElevationCurve{"", {{9, 0}, {9, 5}}, 0, {}, {}}};
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
    const Drawing drawing = drawingOf(document, 0, kDrawingTexts);
    EXPECT_EQ(drawing.figure, figureOf(document.sheets[0], 0));
    EXPECT_EQ(drawing.page.width, kPageSide);
    EXPECT_EQ(drawing.layerTitles.size(), drawing.figure.layers.size());
    EXPECT_EQ(drawing.title, "Word");
}

TEST(Drawing, hasTheLayersAskedForAlone) {
    EXPECT_EQ(layerNames(drawingOf(archAndLine(), 0, kDrawingTexts, {.layers = {{"convex-hull", "curve"}}})),
              (std::vector<std::string_view>{"convex-hull", "curve"}));
}

TEST(Drawing, hasTheCurveAskedForAloneAndAsTheActiveOne) {
    const Drawing drawing = drawingOf(archAndLine(), 0, kDrawingTexts, {.layers = {{"curve"}}, .curve = 1});
    ASSERT_EQ(drawing.figure.layers.size(), 1U);
    ASSERT_EQ(drawing.figure.layers[0].strokes.size(), 1U);
    EXPECT_EQ(drawing.figure.layers[0].strokes[0].curve, 1);
}

TEST(Drawing, leavesLabelsOut) {
    for (const Layer& layer : drawingOf(archAndLine(), 0, kDrawingTexts, {.hasLabels = false}).figure.layers)
        EXPECT_TRUE(layer.labels.empty());
}

TEST(Drawing, hasExactlyTheWidthAskedFor) {
    const Drawing drawing = drawingOf(archAndLine(), 0, kDrawingTexts, {.width = 99.7, .margin = 3});
    EXPECT_EQ(drawing.page.width, 99.7);
    EXPECT_NEAR(onPage(drawing.page, {0, 0}).x, 3, 1e-12);
    EXPECT_NEAR(onPage(drawing.page, {9, 0}).x, 96.7, 1e-12);
    const Drawing upright = drawingOf(archAndLine(), 0, kDrawingTexts, {.width = 50, .curve = 1});
    EXPECT_EQ(upright.page.width, 50);
    EXPECT_NEAR(onPage(upright.page, {9, 1}).x, 25, 1e-12) << "what has no width stands in the middle";
}

} // namespace
} // namespace kriva
