#include "core/io/latex/tikz_writer.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace kriva {
namespace {

using testing::HasSubstr;
using testing::Not;

const TextSource kTikzTexts{[](Caption) { return "Крива"; }, [](double, int) { return std::string(); }, "bg"};

/// A unit is a millimetre and the page 100 mm a side.
Drawing drawingWith(Layer layer) {
    Drawing drawing;
    drawing.page = pageOf({0, 0, 100, 100}, 1, 0);
    drawing.figure.layers.push_back(std::move(layer));
    drawing.title = "100 % curves";
    return drawing;
}

std::string tikzOf(Layer layer) {
    return writeTikz(drawingWith(std::move(layer)), kTikzTexts, TikzKind::fragment);
}

TEST(TikzWriter, drawsLinesAndCubicsAsTheyAre) {
    EXPECT_THAT(tikzOf({"curve", {{polyline(Points{{0, 0}, {10.5, 20}, {30, 0}})}}}),
                HasSubstr("(0,0) -- (10.5,20) -- (30,0);"));
    EXPECT_THAT(tikzOf({"curve", {{singleCurve(Points{{0, 0}, {1, 2}, {3, 4}, {5, 6}})}}}),
                HasSubstr("(0,0)\n    .. controls (1,2) and (3,4) .. (5,6);"));
}

TEST(TikzWriter, drawsAParabolaAsTheCubicThatItIs) {
    EXPECT_THAT(tikzOf({"curve", {{singleCurve(Points{{0, 0}, {30, 60}, {60, 0}})}}}),
                HasSubstr("(0,0)\n    .. controls (20,40) and (40,40) .. (60,0);"));
}

TEST(TikzWriter, followsHigherDegreesWithCubicsThatEndWhereTheyDo) {
    const std::string tikz = tikzOf({"curve", {{singleCurve(Points{{0, 0}, {0, 90}, {50, -50}, {90, 80}, {99, 1}})}}});
    EXPECT_THAT(tikz, HasSubstr(".. (99,1);"));
    EXPECT_THAT(tikz, HasSubstr(".. controls"));
}

TEST(TikzWriter, closesWhatIsClosed) {
    EXPECT_THAT(tikzOf({"curve", {{chain({{{0, 0}, {9, 0}}, {{9, 0}, {9, 9}}, {{9, 9}, {0, 0}}}, true)}}}),
                HasSubstr(" -- cycle;"));
}

TEST(TikzWriter, callsPointsByTheirNames) {
    const Points points{{0, 0}, {10, 20}};
    Layer layer{"curve", {{polyline(points), Role::controlPolygon}}, {{points, Role::point}}};
    layer.labels = {{points[0], Caption::none, "b", "0"}, {points[1], Caption::none, "b", "1"}};
    layer.labels.push_back({{7, 7}, Caption::none, "b[t1,t2]", ""});
    const std::string tikz = tikzOf(layer);
    EXPECT_THAT(tikz, HasSubstr("\\coordinate (b0) at (0,0);\n  \\coordinate (b1) at (10,20);"));
    EXPECT_THAT(tikz, HasSubstr("(b0) -- (b1);"));
    EXPECT_THAT(tikz, HasSubstr("(b1) circle[radius="));
    EXPECT_THAT(tikz, HasSubstr("{$b_{1}$};"));
    EXPECT_THAT(tikz, Not(HasSubstr("\\coordinate (b[")));
}

TEST(TikzWriter, makesAStyleOfEachWayOfDrawing) {
    Stroke own{polyline(Points{{0, 0}, {1, 1}}), Role::curve};
    own.style.dash = LineDash::dashed;
    const Stroke usual{polyline(Points{{0, 0}, {1, 1}}), Role::curve};
    const std::string tikz = tikzOf({"curve", {usual, own, usual}});
    EXPECT_THAT(tikz, HasSubstr("kriva curve/.style={draw={rgb,255:red,0;green,114;blue,178}, line width=1.4bp, "
                                "line cap=round},\n"));
    EXPECT_THAT(tikz, HasSubstr("kriva curve 2/.style={"));
    EXPECT_THAT(tikz, HasSubstr("dash pattern=on 3bp off 1.5bp"));
    EXPECT_THAT(tikz, Not(HasSubstr("kriva curve 3")));
}

TEST(TikzWriter, loadsWhatItNeedsWhereItStandsAlone) {
    Layer layer{"labels"};
    layer.labels.push_back({{1, 1}, Caption::curve, "", ""});
    const std::string alone = writeTikz(drawingWith(layer), kTikzTexts, TikzKind::standalone);
    EXPECT_THAT(alone, HasSubstr("% 100 \\% curves\n\\documentclass{standalone}\n\\usepackage[T1,T2A]{fontenc}"));
    EXPECT_THAT(alone, HasSubstr("{Крива};"));
    EXPECT_THAT(writeTikz(drawingWith({"curve"}), kTikzTexts, TikzKind::standalone), Not(HasSubstr("fontenc")));
}

} // namespace
} // namespace kriva
