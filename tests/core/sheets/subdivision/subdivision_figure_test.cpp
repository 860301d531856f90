#include "core/sheets/subdivision/subdivision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace kriva {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

SubdivisionCurve splitArch() {
    SubdivisionCurve curve;
    curve.points = {{0, 0}, {0, 2}, {8, 2}, {4, 0}};
    curve.multiplicity = {1, 1, 1, 1};
    curve.levels = 2;
    return curve;
}

std::vector<std::string_view> names(const Figure& figure) {
    std::vector<std::string_view> all;
    for (const Layer& layer : figure.layers)
        all.push_back(layer.name);
    return all;
}

Layer layerNamed(std::string_view name, const SubdivisionCurve& curve) {
    for (Layer& layer : figureOf(curve, {}).layers)
        if (layer.name == name)
            return layer;
    ADD_FAILURE() << "no layer " << name;
    return {};
}

TEST(SubdivisionFigure, hasTheLayersOfItsTableInTheirOrder) {
    std::vector<std::string_view> table;
    for (const LayerInfo& info : layersOf(SubdivisionCurve{}))
        table.push_back(info.name);
    EXPECT_EQ(names(figureOf(splitArch(), {})), table);
}

TEST(SubdivisionFigure, derivesNothingFromCurvesThatAreNotActive) {
    EXPECT_THAT(names(figureOf(splitArch(), {0, false})), ElementsAre("control-polygon", "curve", "points", "labels"));
}

TEST(SubdivisionFigure, ofAnIncompleteCurveShowsItsPoints) {
    SubdivisionCurve curve;
    curve.points = {{1, 1}};
    curve.multiplicity = {2};
    EXPECT_THAT(names(figureOf(curve, {})), ElementsAre("control-polygon", "points", "labels"));
}

TEST(SubdivisionFigure, constructionHasOneLineForEachRowBetweenPolygonAndPoint) {
    const Layer layer = layerNamed("construction", splitArch());
    ASSERT_EQ(layer.strokes.size(), 2u);
    EXPECT_EQ(layer.strokes[0].path, polyline(Points{{0, 1}, {4, 2}, {6, 1}}));
    EXPECT_EQ(layer.strokes[0].series, 1);
    EXPECT_EQ(layer.strokes[1].path, polyline(Points{{2, 1.5}, {5, 1.5}}));
    EXPECT_EQ(layer.strokes[1].series, 2);
    EXPECT_THAT(layerNamed("curve-point", splitArch()).marks[0].at, ElementsAre(Point{3.5, 1.5}));
}

TEST(SubdivisionFigure, piecesAreOneLineWithMarksWhereTheyMeet) {
    const Layer layer = layerNamed("pieces", splitArch());
    ASSERT_EQ(layer.strokes.size(), 1u);
    EXPECT_EQ(layer.strokes[0].path.points.size(), 4u * 3 + 1);
    EXPECT_EQ(layer.marks[0].at.size(), 5u);
    EXPECT_EQ(layer.marks[0].at[2], (Point{3.5, 1.5}));
}

TEST(SubdivisionFigure, leftAndRightMeetOnTheCurve) {
    const Layer left = layerNamed("left", splitArch());
    const Layer right = layerNamed("right", splitArch());
    EXPECT_EQ(left.strokes[0].role, Role::left);
    EXPECT_EQ(right.strokes[0].role, Role::right);
    EXPECT_EQ(left.strokes[0].path.points.back(), right.strokes[0].path.points.front());
}

TEST(SubdivisionFigure, drawsTheCurveWithItsControlPointsAsOftenAsTheyStand) {
    SubdivisionCurve curve = splitArch();
    curve.multiplicity = {1, 3, 1, 1};
    EXPECT_EQ(layerNamed("curve", curve).strokes[0].path.degrees, std::vector{5});
    EXPECT_EQ(layerNamed("points", curve).marks[0].at, curve.points);
}

TEST(SubdivisionFigure, labelsTellHowOftenAPointStands) {
    SubdivisionCurve curve = splitArch();
    curve.multiplicity = {1, 3, 1, 1};
    const std::vector<Label> labels = layerNamed("labels", curve).labels;
    ASSERT_EQ(labels.size(), 4u);
    EXPECT_EQ(labels[0].suffix, "");
    EXPECT_EQ(labels[1], (Label{{0, 2}, Caption::none, "b", "1", Role::label, "\u00d73"}));
}

TEST(SubdivisionFigure, labelsOfThePartsKeepOutOfEachOthersWay) {
    const std::vector<Label> labels = layerNamed("part-labels", splitArch()).labels;
    ASSERT_EQ(labels.size(), 8u);
    EXPECT_EQ(labels[3].text + labels[3].subscript, "l3");
    EXPECT_EQ(labels[4].text + labels[4].subscript, "r0");
    EXPECT_EQ(labels[3].at, labels[4].at);
    EXPECT_NE(labels[3].side, labels[4].side);
    EXPECT_NE(labels[0].side, layerNamed("labels", splitArch()).labels[0].side);
}

TEST(SubdivisionFigure, drawsTheSchemeOfTheBlossom) {
    SubdivisionCurve curve = splitArch();
    EXPECT_THAT(layerNamed("blossom", curve).marks, IsEmpty());
    curve.blossom = {0.25, 0.5, 0.75};
    const Layer layer = layerNamed("blossom", curve);
    ASSERT_EQ(layer.strokes.size(), 2u);
    EXPECT_EQ(layer.strokes[0].path, polyline(Points{{0, 0.5}, {2, 2}, {7, 1.5}}));
    EXPECT_EQ(layer.strokes[1].path, polyline(Points{{1, 1.25}, {4.5, 1.75}}));
    EXPECT_THAT(layer.marks.back().at, ElementsAre(Point{3.625, 1.625}));
}

TEST(SubdivisionFigure, namesTheBlossomByItsArguments) {
    SubdivisionCurve curve = splitArch();
    curve.blossom = {0.25, 0.5, 0.75};
    EXPECT_EQ(layerNamed("blossom", curve).labels[0].text, "b[t1,t2,t3]");
    curve.multiplicity[0] = 2;
    curve.blossom = {0, 0.25, 0.5, 0.75};
    EXPECT_EQ(layerNamed("blossom", curve).labels[0].text, "b[t1,...,t4]");
}

TEST(SubdivisionFigure, leavesOutABlossomBeyondTheLimitsOfNumbers) {
    SubdivisionCurve curve = splitArch();
    curve.blossom = {1e9, 1e9, 1e9};
    EXPECT_THAT(layerNamed("blossom", curve).marks, IsEmpty());
}

TEST(SubdivisionFigure, partialCurvesAreOffAtFirstAndMeetTheLineThroughThePoint) {
    const auto table = layersOf(SubdivisionCurve{});
    const auto row = std::find_if(table.begin(), table.end(), [](const auto& l) { return l.name == "partial-curves"; });
    EXPECT_FALSE(row->isShownAtFirst);
    const Layer layer = layerNamed("partial-curves", splitArch());
    ASSERT_EQ(layer.strokes.size(), 3u);
    EXPECT_EQ(layer.strokes[0].path, singleCurve(Points{{0, 0}, {0, 2}, {8, 2}}));
    EXPECT_EQ(layer.strokes[1].path, singleCurve(Points{{0, 2}, {8, 2}, {4, 0}}));
    EXPECT_EQ(layer.strokes[2].path, polyline(Points{{2, 1.5}, {5, 1.5}}));
}

TEST(SubdivisionFigure, drawsTheSchemesAtFurtherParametersEachFainter) {
    const SheetView view = withNumbers({}, kFurtherParameters, {0.25, 0.75});
    const Figure figure = figureOf(splitArch(), {0, true, &view});
    const auto layer = std::ranges::find(figure.layers, "further-constructions", &Layer::name);
    ASSERT_NE(layer, figure.layers.end());
    ASSERT_EQ(layer->strokes.size(), 4u); // two rows of each
    EXPECT_EQ(layer->strokes[0].path, polyline(deCasteljau(splitArch().points, 0.25)[1]));
    EXPECT_EQ(layer->strokes[3].path, polyline(deCasteljau(splitArch().points, 0.75)[2]));
    EXPECT_LT(layer->strokes[0].strength, 1);
    EXPECT_LT(layer->strokes[2].strength, layer->strokes[0].strength);
    EXPECT_EQ(layer->marks.at(0).at.size(), 2u);
    EXPECT_THAT(layerNamed("further-constructions", splitArch()).strokes, IsEmpty());
}

TEST(SubdivisionFigure, aLineHasNoPartialCurves) {
    SubdivisionCurve curve = splitArch();
    curve.points.resize(2);
    curve.multiplicity.resize(2);
    EXPECT_THAT(layerNamed("partial-curves", curve).strokes, IsEmpty());
    EXPECT_THAT(layerNamed("construction", curve).strokes, IsEmpty());
}

} // namespace
} // namespace kriva
