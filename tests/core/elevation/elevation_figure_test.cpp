#include "core/elevation/elevation_figure.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace kriva {
namespace {

using testing::ElementsAre;

ElevationCurve example() {
    ElevationCurve curve;
    curve.points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    curve.times = 1;
    return curve;
}

std::vector<std::string_view> names(const Figure& figure) {
    std::vector<std::string_view> all;
    for (const Layer& layer : figure.layers)
        all.push_back(layer.name);
    return all;
}

TEST(ElevationFigure, hasTheLayersOfItsTableInTheirOrder) {
    std::vector<std::string_view> table;
    for (const LayerInfo& info : layersOf(ElevationCurve{}))
        table.push_back(info.name);
    EXPECT_EQ(names(figureOf(example(), {})), table);
}

TEST(ElevationFigure, derivesNothingFromCurvesThatAreNotActive) {
    EXPECT_THAT(names(figureOf(example(), {0, false})), ElementsAre("control-polygon", "curve", "points", "labels"));
}

TEST(ElevationFigure, ofAnIncompleteCurveShowsItsPoints) {
    ElevationCurve curve;
    EXPECT_THAT(names(figureOf(curve, {})), ElementsAre("control-polygon", "points", "labels"));
    curve.points = {{1, 1}};
    EXPECT_THAT(figureOf(curve, {}).layers[1].marks[0].at, ElementsAre(Point{1, 1}));
}

TEST(ElevationFigure, drawsTheCurveItselfWithItsOwnStyle) {
    ElevationCurve curve = example();
    curve.style.width = 3;
    const Layer layer = figureOf(curve, {}).layers[2];
    ASSERT_EQ(layer.strokes.size(), 1u);
    EXPECT_EQ(layer.strokes[0].path, singleCurve(curve.points));
    EXPECT_EQ(layer.strokes[0].style.width, 3);
}

TEST(ElevationFigure, drawsTheElevatedPolygonWithItsPoints) {
    const Layer layer = figureOf(example(), {}).layers[1];
    const Points polygon{{0, 0}, {0.75, 1.5}, {2, 2}, {3.25, 1.5}, {4, 0}};
    EXPECT_EQ(layer.strokes[0].path, polyline(polygon));
    EXPECT_EQ(layer.marks[0].at, polygon);
}

TEST(ElevationFigure, labelsThePoints) {
    const std::vector<Label> labels = figureOf(example(), {}).layers.back().labels;
    ASSERT_EQ(labels.size(), 4u);
    EXPECT_EQ(labels[3], (Label{{4, 0}, Caption::none, "b", "3"}));
}

} // namespace
} // namespace kriva
