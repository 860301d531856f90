#include "core/bezier/elevate.h"
#include "core/bezier/evaluate.h"
#include "core/sheets/elevation/elevation.h"
#include "core/sheets/elevation/elevation_layers.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>

namespace kriva {
namespace {

using testing::ElementsAre;

ElevationCurve raisedArch() {
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

Layer layerOf(const Figure& figure, std::string_view name) {
    const auto found = std::ranges::find(figure.layers, name, &Layer::name);
    if (found == figure.layers.end())
        throw std::runtime_error("no layer " + std::string(name));
    return *found;
}

TEST(ElevationFigure, hasTheLayersOfItsTableInTheirOrder) {
    std::vector<std::string_view> table;
    for (const LayerInfo& info : layersOf(ElevationCurve{}))
        table.push_back(info.name);
    EXPECT_EQ(names(figureOf(raisedArch(), {})), table);
}

TEST(ElevationFigure, derivesNothingFromCurvesThatAreNotActive) {
    EXPECT_THAT(names(figureOf(raisedArch(), {0, false})), ElementsAre("control-polygon", "curve", "points", "labels"));
}

TEST(ElevationFigure, ofAnIncompleteCurveShowsItsPoints) {
    ElevationCurve curve;
    EXPECT_THAT(names(figureOf(curve, {})), ElementsAre("control-polygon", "points", "labels"));
    curve.points = {{1, 1}};
    EXPECT_THAT(layerOf(figureOf(curve, {}), "points").marks[0].at, ElementsAre(Point{1, 1}));
}

TEST(ElevationFigure, drawsTheCurveItselfWithItsOwnStyle) {
    ElevationCurve curve = raisedArch();
    curve.style.width = 3;
    const Layer layer = layerOf(figureOf(curve, {}), "curve");
    ASSERT_EQ(layer.strokes.size(), 1u);
    EXPECT_EQ(layer.strokes[0].path, singleCurve(curve.points));
    EXPECT_EQ(layer.strokes[0].style.width, 3);
}

TEST(ElevationFigure, drawsTheElevatedPolygonWithItsPoints) {
    const Layer layer = layerOf(figureOf(raisedArch(), {}), "elevated-polygon");
    const Points polygon{{0, 0}, {0.75, 1.5}, {2, 2}, {3.25, 1.5}, {4, 0}};
    EXPECT_EQ(layer.strokes[0].path, polyline(polygon));
    EXPECT_EQ(layer.marks[0].at, polygon);
}

TEST(ElevationFigure, labelsThePoints) {
    const std::vector<Label> labels = figureOf(raisedArch(), {}).layers.back().labels;
    ASSERT_EQ(labels.size(), 4u);
    EXPECT_EQ(labels[3], (Label{{4, 0}, Caption::none, "b", "3"}));
}

TEST(ElevationFigure, derivedLayersAreOffAtFirstAndOnlyMadeWhereTheyAreShown) {
    SheetView view;
    const FigureContext context{0, true, &view};
    EXPECT_THAT(names(figureOf(raisedArch(), context)),
                ElementsAre("control-polygon", "elevated-polygon", "curve", "points", "labels"));
    view.layers = {{"convex-hull", true}, {"end-tangents", true}};
    EXPECT_THAT(
        names(figureOf(raisedArch(), context)),
        ElementsAre("convex-hull", "control-polygon", "elevated-polygon", "end-tangents", "curve", "points", "labels"));
}

TEST(ElevationLayers, showAllElevationsOrAHundredPolygonsAtEvenDistances) {
    EXPECT_THAT(shownElevations(0), testing::IsEmpty());
    EXPECT_THAT(shownElevations(1), testing::IsEmpty());
    EXPECT_THAT(shownElevations(4), ElementsAre(1, 2, 3));
    for (const int times : {97, 99, 100, 101, 10'000}) {
        const std::vector<int> shown = shownElevations(times);
        ASSERT_EQ(shown.size(), static_cast<std::size_t>(times == 10'000 ? 10 : std::min(times - 1, 98)));
        for (std::size_t i = 0; i <= shown.size(); ++i) {
            const int step = (i < shown.size() ? shown[i] : times) - (i > 0 ? shown[i - 1] : 0);
            EXPECT_GE(step, times / static_cast<int>(shown.size() + 1)) << times;
            EXPECT_LE(step, times / static_cast<int>(shown.size() + 1) + 1) << times;
        }
    }
}

RC_GTEST_PROP(ElevationLayers, everyFadingPolygonIsTheElevatedOne, ()) {
    ElevationCurve curve;
    curve.points = *test::anyCurve(1, 12);
    curve.times = *rc::gen::inRange(2, 150);
    const Layer layer = allPolygonsLayer(curve);
    const std::vector<int> shown = shownElevations(curve.times);
    RC_ASSERT(layer.strokes.size() == shown.size());
    const double size = diagonal(boxOf(curve.points));
    double strength = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const Points exact = elevated(curve.points, shown[i]);
        const Points& drawn = layer.strokes[i].path.points;
        RC_ASSERT(drawn.size() == exact.size());
        for (std::size_t j = 0; j < exact.size(); ++j)
            RC_ASSERT(distance(drawn[j], exact[j]) <= 1e-13 * (size + distance({}, exact[j])));
        RC_ASSERT(layer.strokes[i].strength > strength);
        strength = layer.strokes[i].strength;
    }
    RC_ASSERT(strength < 1);
}

RC_GTEST_PROP(ElevationLayers, theCurveStaysInTheHullOfThePolygonOnView, ()) {
    ElevationCurve curve;
    curve.points = *test::anyCurve(1, 12);
    curve.times = *rc::gen::inRange(0, 20);
    const Path hull = layerOf(figureOf(curve, {}), "convex-hull").strokes.at(0).path;
    const double size = diagonal(boxOf(curve.points)) + distance({}, curve.points[0]);
    for (int i = 0; i <= 32; ++i) {
        const Point p = evaluate(curve.points, i / 32.0);
        for (std::size_t j = 0; hull.isClosed && j + 1 < hull.points.size(); ++j) {
            const Vector side = hull.points[j + 1] - hull.points[j];
            RC_ASSERT(cross(side, p - hull.points[j]) >= -1e-12 * size * length(side));
        }
    }
}

TEST(ElevationLayers, theHullFollowsTheElevatedPolygon) {
    ElevationCurve curve = raisedArch();
    EXPECT_EQ(layerOf(figureOf(curve, {}), "convex-hull").strokes[0].path.points,
              (Points{{0, 0}, {4, 0}, {3.25, 1.5}, {2, 2}, {0.75, 1.5}, {0, 0}}));
    curve.points = {{0, 0}, {1, 1}, {2, 2}};
    EXPECT_FALSE(layerOf(figureOf(curve, {}), "convex-hull").strokes[0].path.isClosed);
}

TEST(ElevationLayers, tangentsRunAlongTheFirstAndLastLegsAndBeyond) {
    const Layer layer = endTangentsLayer(Points{{0, 0}, {0, 0}, {1, 2}, {3, 2}, {4, 0}});
    ASSERT_EQ(layer.strokes.size(), 4u); // two lines, two heads
    EXPECT_EQ(layer.strokes[0].path.points[0], (Point{0, 0}));
    const Point tip = layer.strokes[0].path.points[1];
    EXPECT_NEAR(cross(tip - Point{}, Vector{1, 2}), 0, 1e-12);
    EXPECT_GT(length(tip - Point{}), std::hypot(1, 2));
    EXPECT_EQ(layer.strokes[1].path.points[1], tip);
    EXPECT_EQ(layer.strokes[2].path.points[0], (Point{3, 2}));
    EXPECT_LT(layer.strokes[2].path.points[1].y, 0);
    EXPECT_THAT(endTangentsLayer(Points{{1, 1}, {1, 1}}).strokes, testing::IsEmpty());
}

TEST(ElevationLayers, tangentsAreSeenHoweverShortTheLegs) {
    const Points raised = elevated(Points{{0, 0}, {1, 4}, {6, 5}, {8, 1}}, 97);
    const Layer layer = endTangentsLayer(raised);
    const Vector tangent = layer.strokes[0].path.points[1] - raised[0];
    EXPECT_GT(length(tangent), 0.5); // the leg's length is 0.12
    EXPECT_NEAR(cross(tangent, Vector{1, 4}), 0, 1e-12);
}

TEST(ElevationLayers, tangentsAreFiniteWhereALegIsNearlyNothing) {
    for (const Stroke& stroke : endTangentsLayer(Points{{0, 0}, {1e-320, 0}, {2, 1}, {3, 0}}).strokes)
        EXPECT_TRUE(std::ranges::all_of(stroke.path.points, [](Point p) { return isFinite(p); }));
}

} // namespace
} // namespace kriva
