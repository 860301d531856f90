#include "core/figure/figure.h"

#include <gtest/gtest.h>

#include <array>

namespace kriva {
namespace {

constexpr std::array kTable{LayerInfo{"low"}, LayerInfo{"off", Caption::none, false},
                            LayerInfo{"own", Caption::none, true, true}, LayerInfo{"high"}};

std::vector<std::string_view> names(const Figure& figure) {
    std::vector<std::string_view> all;
    for (const Layer& layer : figure.layers)
        all.push_back(layer.name);
    return all;
}

TEST(Figure, unitesLayersByNameInTheOrderOfTheTable) {
    Figure first{{{"high", {}, {{{{1, 1}}}}}, {"low"}}};
    Figure second{{{"high", {}, {{{{2, 2}}}}}}};
    const Figure all = united({first, second}, kTable);
    EXPECT_EQ(names(all), (std::vector<std::string_view>{"low", "high"}));
    ASSERT_EQ(all.layers[1].marks.size(), 2u);
    EXPECT_EQ(all.layers[1].marks[1].at[0], (Point{2, 2}));
}

TEST(Figure, hidesWhatIsOffAtFirstOrSwitchedOffOrOfTheActiveCurveOnly) {
    const Figure figure{{{"low"}, {"off"}, {"own"}, {"high"}}};
    SheetView view;
    EXPECT_EQ(names(shownLayers(figure, kTable, {0, true, &view})),
              (std::vector<std::string_view>{"low", "own", "high"}));
    EXPECT_EQ(names(shownLayers(figure, kTable, {0, false, &view})), (std::vector<std::string_view>{"low", "high"}));
    view.layers = {{"low", false}, {"off", true}};
    EXPECT_EQ(names(shownLayers(figure, kTable, {0, true, &view})),
              (std::vector<std::string_view>{"off", "own", "high"}));
}

TEST(Figure, stagesHideWhatComesLaterAndShowWhatTheyBring) {
    constexpr std::array table{LayerInfo{"given"}, LayerInfo{"step", Caption::none, false, true, 1},
                               LayerInfo{"whole", Caption::none, true, false, 2}};
    const Figure figure{{{"given"}, {"step"}, {"whole"}}};
    SheetView view;
    const auto at = [&](std::optional<int> stage) {
        return names(shownLayers(figure, table, {0, true, &view, stage}));
    };
    using Names = std::vector<std::string_view>;
    EXPECT_EQ(at(0), (Names{"given"}));
    EXPECT_EQ(at(1), (Names{"given", "step"}));
    EXPECT_EQ(at(2), (Names{"given", "whole"}));
    EXPECT_EQ(at({}), (Names{"given", "whole"}));
    view.layers = {{"step", false}, {"given", false}};
    EXPECT_EQ(at(1), Names{});
}

TEST(Figure, boxHoldsCurvesNotTheirControlPoints) {
    Figure figure;
    figure.layers.push_back({"low", {{singleCurve(Points{{0, 0}, {1, 2}, {3, 2}, {4, 0}})}}});
    EXPECT_EQ(boxOf(figure), (Box{0, 0, 4, 1.5}));
    figure.layers.push_back({"high", {{polyline(Points{{5, 1}, {5, 3}})}}, {{{{-1, 1}}}}});
    Label label;
    label.at = {2, -7};
    figure.layers.back().labels.push_back(label);
    EXPECT_EQ(boxOf(figure), (Box{-1, -7, 5, 3}));
    EXPECT_TRUE(boxOf(Figure{}).isEmpty());
}

TEST(Figure, chainStartsEachPieceWhereTheOneBeforeEnded) {
    const Path path = chain({{{0, 0}, {1, 1}}, {{1, 1}, {2, 2}, {3, 1}}}, false);
    EXPECT_EQ(path.points, (Points{{0, 0}, {1, 1}, {2, 2}, {3, 1}}));
    EXPECT_EQ(path.degrees, (std::vector{1, 2}));
    std::vector<std::size_t> sizes;
    forEachPiece(path, [&](std::span<const Point> piece) { sizes.push_back(piece.size()); });
    EXPECT_EQ(sizes, (std::vector<std::size_t>{2, 3}));
}

TEST(Figure, polylineOfOnePointHasNoPiece) {
    EXPECT_TRUE(polyline(Points{{1, 1}}).degrees.empty());
    EXPECT_TRUE(polyline(Points{}).points.empty());
}

TEST(Figure, aStyleChangesTheMarksOfPointsAloneAndTakesLabelsAway) {
    const Layer layer{
        "points", {}, {{{{0, 0}}, Role::point}, {{{1, 1}}, Role::handle}}, {Label{{0, 0}, Caption::none, "b", ""}}};
    CurveStyle style;
    style.marker = Marker::square;
    EXPECT_EQ(styled({{layer}}, {}), (Figure{{layer}}));
    Figure figure = styled({{layer}}, style);
    EXPECT_EQ(figure.layers[0].marks[0].marker, Marker::square);
    EXPECT_EQ(figure.layers[0].marks[1].marker, std::nullopt);
    EXPECT_EQ(figure.layers[0].labels.size(), 1u);
    style.hasLabels = false;
    EXPECT_TRUE(styled({{layer}}, style).layers[0].labels.empty());
}

} // namespace
} // namespace kriva
