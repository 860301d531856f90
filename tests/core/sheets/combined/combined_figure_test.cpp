#include "core/document/sheet_figure.h"
#include "core/sheets/combined/combined.h"
#include "tests/support/sheet_curves.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace kriva {
namespace {

using testing::Contains;
using testing::ElementsAre;

CombinedCurve threeRuns(CombinedCurve::Method method) {
    CombinedCurve curve;
    curve.points = {{0, 0}, {1, 2}, {3, 1}, {2, 4}, {0, 5}, {0, 7}};
    curve.method = method;
    return curve;
}

const Layer& layerOf(const Figure& figure, std::string_view name) {
    return *std::ranges::find(figure.layers, name, &Layer::name);
}

TEST(CombinedFigure, drawsItsLayersInTheOrderOfTheTable) {
    const Figure figure = figureOf(threeRuns(CombinedCurve::Method::approximation), {});
    const std::span<const LayerInfo> table = layersOf(CombinedCurve{});
    ASSERT_EQ(figure.layers.size(), table.size());
    for (std::size_t i = 0; i < table.size(); ++i)
        EXPECT_EQ(figure.layers[i].name, table[i].name);
}

TEST(CombinedFigure, givesEveryRunItsOwnSeriesAndNumber) {
    const Figure figure = figureOf(threeRuns(CombinedCurve::Method::pairs), {});
    const Layer& runs = layerOf(figure, "runs");
    // The third run is a single point: it has a number, no piece.
    ASSERT_EQ(runs.strokes.size(), 2u);
    EXPECT_EQ(runs.strokes[0].series, 0);
    EXPECT_EQ(runs.strokes[1].series, 1);
    EXPECT_EQ(runs.strokes[1].path.points.front(), (Point{2, 4}));
    EXPECT_EQ(layerOf(figure, "run-numbers").labels.size(), 3u);
    EXPECT_EQ(layerOf(figure, "joins").strokes.size(), 2u);
}

TEST(CombinedFigure, drawsTheWholePathAsTheCurve) {
    const Figure figure = figureOf(threeRuns(CombinedCurve::Method::approximation), {4, false});
    const Layer& curve = layerOf(figure, "curve");
    ASSERT_EQ(curve.strokes.size(), 1u);
    EXPECT_EQ(curve.strokes[0].curve, 4);
    EXPECT_EQ(curve.strokes[0].path.degrees.size(), 4u);
    EXPECT_EQ(curve.strokes[0].path.points.back(), (Point{0, 7}));
}

TEST(CombinedFigure, marksTheMiddlePointsOfPairs) {
    CombinedCurve curve = threeRuns(CombinedCurve::Method::pairs);
    curve.corrections[0] = {0.5, 3};
    const Figure figure = figureOf(curve, {});
    const Layer& middles = layerOf(figure, "middle-points");
    ASSERT_EQ(middles.marks.size(), 1u);
    ASSERT_EQ(middles.marks[0].at.size(), 3u);
    EXPECT_EQ(middles.marks[0].at[0], (Point{0.5, 3}));
    ASSERT_EQ(middles.strokes.size(), 2u);
    EXPECT_EQ(middles.strokes[0].path.points.size(), 5u);
    EXPECT_EQ(middles.strokes[0].path.points[1], (Point{0.5, 3}));
}

TEST(CombinedFigure, showsThePointsOfACurveWithoutPieces) {
    CombinedCurve curve;
    EXPECT_TRUE(layerOf(figureOf(curve, {}), "curve").strokes.empty());
    curve.points = {{1, 1}};
    const Figure figure = figureOf(curve, {});
    EXPECT_EQ(layerOf(figure, "points").marks[0].at, curve.points);
    EXPECT_EQ(layerOf(figure, "labels").labels.size(), 1u);
}

std::vector<std::string_view> namesAt(std::optional<int> stage, const SheetView& view = {}) {
    Sheet sheet;
    sheet.curves = test::curves({threeRuns(CombinedCurve::Method::pairs)});
    sheet.view = view;
    std::vector<std::string_view> names;
    for (const Layer& layer : figureOf(sheet, test::kCombined, stage).layers)
        names.push_back(layer.name);
    return names;
}

TEST(CombinedFigure, stagesBringTheLayersOneAfterTheOther) {
    EXPECT_THAT(namesAt(0), ElementsAre("given-polygon", "points", "labels"));
    EXPECT_THAT(namesAt(1), ElementsAre("given-polygon", "run-polygons", "points", "run-numbers", "labels"));
    EXPECT_THAT(namesAt(2), ElementsAre("given-polygon", "polynomials", "points", "run-numbers", "labels"));
    EXPECT_THAT(namesAt(3),
                ElementsAre("given-polygon", "runs", "joins", "middle-points", "points", "run-numbers", "labels"));
    EXPECT_EQ(namesAt(kCombinedStages - 1), namesAt({}));
}

TEST(CombinedFigure, stagesShowNothingThatIsSwitchedOff) {
    SheetView view;
    view.layers = {{"run-polygons", false}, {"labels", false}, {"polynomials", true}};
    EXPECT_THAT(namesAt(1, view), ElementsAre("given-polygon", "points", "run-numbers"));
    EXPECT_THAT(namesAt(2, view), ElementsAre("given-polygon", "polynomials", "points", "run-numbers"));
    EXPECT_THAT(namesAt(3, view), Contains("polynomials"));
}

TEST(CombinedFigure, aStageIsOfTheActiveCurveAlone) {
    Sheet sheet;
    sheet.curves = test::curves({CombinedCurve{}, threeRuns(CombinedCurve::Method::pairs)});
    EXPECT_FALSE(layerOf(figureOf(sheet, test::kCombined, 0), "curve").strokes.empty());
}

TEST(CombinedFigure, drawsTheRunsPolygonsAndPolynomials) {
    const CombinedCurve curve = threeRuns(CombinedCurve::Method::pairs);
    const Figure figure = figureOf(curve, {});
    const Layer& polygons = layerOf(figure, "run-polygons");
    ASSERT_EQ(polygons.strokes.size(), 3u);
    EXPECT_EQ(polygons.strokes[0].path.points, (Points{{0, 0}, {1, 2}, {3, 1}}));
    EXPECT_EQ(polygons.strokes[1].series, 1);
    const Layer& polynomials = layerOf(figure, "polynomials");
    ASSERT_EQ(polynomials.strokes.size(), 2u);
    EXPECT_EQ(polynomials.strokes[0].path, chain(combine(curve).runs[0].parts, false));
}

TEST(CombinedFigure, leavesOutWhatDoublesCannotHold) {
    CombinedCurve curve;
    curve.points = {{0, 0}, {1e-300, 1e9}, {2e-300, 0}, {1, 1}, {0, 2}};
    const Figure figure = figureOf(curve, {});
    for (const Layer& layer : figure.layers)
        for (const Stroke& stroke : layer.strokes)
            EXPECT_TRUE(std::ranges::all_of(stroke.path.points, isFinite)) << layer.name;
    for (const Label& label : layerOf(figure, "run-numbers").labels)
        EXPECT_TRUE(isFinite(label.at));
}

} // namespace
} // namespace kriva
