#include "core/figure/label_placement.h"
#include "core/figure/labels.h"
#include "core/figure/obstacles.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

const TextSource kTexts{[](Caption) { return std::string("Word"); }, [](double, int) { return std::string(); }, "en"};

std::vector<PlacedLabel> placed(Layer layer) {
    Figure figure;
    figure.layers.push_back(std::move(layer));
    return placedLabels(figure, pageOf(boxOf(figure)), kTexts).front();
}

TEST(LabelPlacement, turnsLabelsOutOfThePolygon) {
    const Points square{{0, 0}, {0, 4}, {4, 4}, {4, 0}};
    const std::vector<PlacedLabel> labels = placed({"labels", {{polyline(square)}}, {}, indexedLabels("b", square)});
    ASSERT_EQ(labels.size(), 4U);
    const Page page = pageOf(boxOf(square));
    EXPECT_LT(labels[1].baseline.x, onPage(page, square[1]).x);
    EXPECT_EQ(labels[1].anchor, TextAnchor::end);
    EXPECT_LT(labels[1].baseline.y, onPage(page, square[1]).y);
    EXPECT_GT(labels[2].baseline.x, onPage(page, square[2]).x);
    EXPECT_EQ(labels[2].anchor, TextAnchor::start);
    EXPECT_GT(labels[3].baseline.y, onPage(page, square[3]).y);
}

TEST(LabelPlacement, keepsClearOfLines) {
    // One line leaves the point to where a lone label would stand: up and right.
    const Points free{{0, 0}};
    const Points ray{{0, 0}, {10, 10}};
    const std::vector<Label> label = indexedLabels("b", free);
    const PlacedLabel alone = placed({"labels", {{polyline(Points{{0, 0}, {10, -10}})}}, {}, label}).front();
    const PlacedLabel beside = placed({"labels", {{polyline(ray)}}, {}, label}).front();
    EXPECT_EQ(alone.anchor, TextAnchor::start);
    EXPECT_NE(beside.anchor, TextAnchor::start);
}

TEST(LabelPlacement, keepsLabelsOfOnePlaceApart) {
    Layer layer{"labels"};
    for (const char* letter : {"a", "b", "c"})
        layer.labels.push_back({{0, 0}, Caption::none, letter, ""});
    const std::vector<PlacedLabel> labels = placed(layer);
    ASSERT_EQ(labels.size(), 3U);
    EXPECT_NE(labels[0].baseline, labels[1].baseline);
    EXPECT_NE(labels[0].baseline, labels[2].baseline);
    EXPECT_NE(labels[1].baseline, labels[2].baseline);
}

TEST(LabelPlacement, mergesLabelsThatSayTheSameInTheSamePlace) {
    Layer layer{"labels"};
    layer.labels = {{{0, 0}, Caption::none, "b", "0"}, {{1, 0}, Caption::none, "b", "0"}};
    layer.labels.push_back(layer.labels.front());
    EXPECT_EQ(placed(layer).size(), 2U);
}

TEST(LabelPlacement, translatesCaptionsAndSetsOnlyLettersInItalics) {
    Layer layer{"labels"};
    layer.labels = {
        {{0, 0}, Caption::curve, "", ""}, {{1, 1}, Caption::none, "P", "1"}, {{2, 0}, Caption::none, "5", ""}};
    const std::vector<PlacedLabel> labels = placed(layer);
    EXPECT_EQ(labels[0].text, "Word");
    EXPECT_FALSE(labels[0].isVariable);
    EXPECT_TRUE(labels[1].isVariable);
    EXPECT_FALSE(labels[2].isVariable);
}

TEST(LabelPlacement, placesManyLabelsToo) {
    Points points;
    for (int i = 0; i < 100'000; ++i)
        points.push_back({i * 1e-3, static_cast<double>(i % 7)});
    EXPECT_EQ(placed({"labels", {{polyline(points)}}, {}, indexedLabels("b", points)}).size(), points.size());
}

TEST(Obstacles, measureTheLineInsideABox) {
    const Box box{0, 0, 2, 1};
    EXPECT_DOUBLE_EQ(lengthInside(box, {-1, 0.5}, {5, 0.5}), 2);
    EXPECT_DOUBLE_EQ(lengthInside(box, {0.5, 0.5}, {0.5, 7}), 0.5);
    EXPECT_DOUBLE_EQ(lengthInside(box, {0.5, 0.5}, {1.5, 0.5}), 1);
    EXPECT_EQ(lengthInside(box, {-1, 3}, {5, 3}), 0);
    EXPECT_EQ(lengthInside(box, {-1, 0.5}, {0.9, 2.4}), 0) << "passes the corner";
    EXPECT_EQ(lengthInside(box, {1, 0.5}, {1, 0.5}), 0);
}

} // namespace
} // namespace kriva
