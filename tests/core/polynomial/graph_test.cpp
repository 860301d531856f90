#include "core/bezier/evaluate.h"
#include "core/polynomial/graph.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace kriva {
namespace {

Polynomial through(std::span<const Point> points) {
    std::vector<double> nodes;
    std::vector<DoubleDouble> values;
    for (const Point p : points) {
        nodes.push_back(p.x);
        values.emplace_back(p.y);
    }
    return interpolate(nodes, values);
}

Points anyPoints() {
    Points points;
    const int count = *rc::gen::inRange(2, 9);
    for (int i = 0; i < count; ++i)
        points.push_back({i + *rc::gen::inRange(0, 64) / 128.0, *rc::gen::inRange(-100, 100) / 16.0});
    return points;
}

RC_GTEST_PROP(GraphOf, isTheGraphAsABezierCurve, ()) {
    const Points points = anyPoints();
    const Polynomial polynomial = through(points);
    const Graph graph = graphOf(polynomial, points.back().x, points.front().x);
    // Roundings are as large as the control points make them, which may lie far beyond the curve.
    double size = 1;
    for (const Point p : graph.curve)
        size = std::max(size, std::abs(p.y));
    // Values are exact to many more digits than a double has, but a zero is not always met.
    for (const auto& [end, point] :
         {std::pair(graph.curve.front(), points.back()), {graph.curve.back(), points.front()}}) {
        RC_ASSERT(end.x == point.x);
        RC_ASSERT(std::abs(end.y - point.y) <= 1e-20 * size);
    }
    for (const double t : {0.125, 0.5, 0.8125}) {
        const Point at = evaluate(graph.curve, t);
        RC_ASSERT(std::abs(at.x - lerp(points.back(), points.front(), t).x) < 1e-13);
        RC_ASSERT(std::abs(at.y - valueAt(polynomial, at.x).toDouble()) < 1e-10 * size);
    }
}

RC_GTEST_PROP(GraphOf, hasTheSlopesOfItsCurve, ()) {
    const Points points = anyPoints();
    const Graph graph = graphOf(through(points), points.front().x, points.back().x);
    const Vector start = derivative(graph.curve, 0);
    const Vector end = derivative(graph.curve, 1);
    RC_ASSERT(std::abs(graph.startSlope.high - start.y / start.x) < 1e-9 * (1 + std::abs(graph.startSlope.high)));
    RC_ASSERT(std::abs(graph.endSlope.high - end.y / end.x) < 1e-9 * (1 + std::abs(graph.endSlope.high)));
}

RC_GTEST_PROP(GraphOf, variesInSlopeAsMuchBackwards, ()) {
    const Points points = anyPoints();
    const Polynomial polynomial = through(points);
    const double forwards = graphOf(polynomial, points.front().x, points.back().x).slopeVariation;
    const double backwards = graphOf(polynomial, points.back().x, points.front().x).slopeVariation;
    RC_ASSERT(std::abs(forwards - backwards) <= 2e-11 * forwards);
}

TEST(GraphOf, sumsTheTurnsOfTheSlope) {
    // y = x^3 - x on [-1, 1]: the slope falls from 2 to -1 and rises to 2.
    const Graph graph = graphOf(through(Points{{-1, 0}, {0, 0}, {1, 0}, {2, 6}}), -1, 1);
    EXPECT_NEAR(graph.slopeVariation, 6, 1e-10);
    EXPECT_EQ(graph.startSlope.high, 2);
    EXPECT_EQ(graph.endSlope.high, 2);
}

TEST(GraphOf, isOnePartWhereDoublesTellIt) {
    const Graph graph = graphOf(through(Points{{0, 0}, {1, 5}, {2, 1}}), 0, 2);
    ASSERT_EQ(graph.parts.size(), 1u);
    EXPECT_EQ(graph.parts[0], graph.curve);
}

TEST(GraphOf, isCutWhereControlPointsAreFarLargerThanTheCurve) {
    // Runge's function at 101 Chebyshev points: values from 0 to 1, control points beyond 1e9.
    Points points;
    for (int i = 0; i <= 100; ++i) {
        const double x = -std::cos(i * 3.141592653589793 / 100);
        points.push_back({x, 1 / (1 + 25 * x * x)});
    }
    const Polynomial polynomial = through(points);
    const Graph graph = graphOf(polynomial, -1, 1);
    double largest = 0;
    for (const Point p : graph.curve)
        largest = std::max(largest, std::abs(p.y));
    EXPECT_GT(largest, 1e9);
    ASSERT_GT(graph.parts.size(), 1u);
    EXPECT_EQ(graph.parts.back().back(), graph.curve.back());
    for (std::size_t i = 0; i < graph.parts.size(); ++i) {
        const Point before = i == 0 ? graph.curve.front() : graph.parts[i - 1].back();
        EXPECT_EQ(graph.parts[i].front(), before);
        const Point middle = evaluate(graph.parts[i], 0.5);
        EXPECT_NEAR(middle.y, 1 / (1 + 25 * middle.x * middle.x), 1e-7);
        EXPECT_NEAR(middle.y, valueAt(polynomial, middle.x).toDouble(), 1e-13);
    }
    // The slope of Runge's function runs from 25/338 up to 45/16 / sqrt(3) * 10/9, down to its negative and back.
    EXPECT_NEAR(graph.slopeVariation, 4 * 3.2475952641916450 - 2 * 25.0 / 338, 1e-5);
}

} // namespace
} // namespace kriva
