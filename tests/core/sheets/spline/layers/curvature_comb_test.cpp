#include "core/bezier/bounds.h"
#include "core/bezier/evaluate.h"
#include "core/bezier/measures/curvature.h"
#include "core/sheets/spline/layers/curvature_comb.h"
#include "tests/core/sheets/spline/spline_values.h"

namespace kriva {
namespace {

using test::curveThrough;
using Rule = SplineCurve::Rule;

Layer combOf(const SplineCurve& curve, double factor = 1) {
    return curvatureCombLayer(segmentsOf(curve), shapesOf(curve), factor);
}

double longestTooth(const Layer& comb) {
    double longest = 0;
    for (const Stroke& stroke : comb.strokes)
        if (stroke.series == 0)
            longest = std::max(longest, distance(stroke.path.points[0], stroke.path.points[1]));
    return longest;
}

RC_GTEST_PROP(CurvatureComb, teethStandOnTheCurveUprightAndAsLongAsItIsCurved, ()) {
    const SplineCurve curve = test::anySpline();
    const std::vector<Points> segments = segmentsOf(curve);
    const CombTeeth teeth = combTeeth(segments, shapesOf(curve), 8);
    RC_ASSERT(teeth.size() == segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        RC_ASSERT(teeth[i].size() == 9u);
        for (std::size_t step = 0; step <= 8; ++step) {
            const double t = static_cast<double>(step) / 8;
            if (!teeth[i][step])
                continue;
            const CombTooth& tooth = *teeth[i][step];
            RC_ASSERT(tooth.foot == evaluate(segments[i], t));
            RC_ASSERT(std::abs(length(tooth.outwards) - 1) < 1e-12);
            const Vector way = derivative(shapesOf(curve)[i], t);
            RC_ASSERT(std::abs(dot(way, tooth.outwards)) <= 1e-12 * length(way));
            RC_ASSERT(cross(way, tooth.outwards) < 0); // to the right
            RC_ASSERT(tooth.curvature == *curvature(shapesOf(curve)[i], t));
            const CombScale scale{2.5, 1e300};
            RC_ASSERT(endOf(tooth, scale) == tooth.foot + 2.5 * tooth.curvature * tooth.outwards);
        }
    }
}

RC_GTEST_PROP(CurvatureComb, isFiniteAndNoLongerThanItsScale, ()) {
    const SplineCurve curve = test::anySpline();
    Box box;
    for (const Points& segment : segmentsOf(curve))
        box = united(box, tightBounds(segment));
    const Layer comb = combOf(curve);
    for (const Stroke& stroke : comb.strokes)
        RC_ASSERT(std::ranges::all_of(stroke.path.points, isFinite));
    RC_ASSERT(longestTooth(comb) <= 0.2 * diagonal(box) + 1e-9);
}

TEST(CurvatureComb, ofACircleIsACircleOutside) {
    constexpr double kHandle = 0.5522847498;
    const std::vector<Points> quarter{{{1, 0}, {1, kHandle}, {kHandle, 1}, {0, 1}}};
    const Layer comb = curvatureCombLayer(quarter, quarter, 1);
    const Stroke& line = comb.strokes.back();
    EXPECT_EQ(line.series, 1);
    for (const Point end : line.path.points)
        EXPECT_NEAR(distance({}, end), 1 + 0.2 * std::sqrt(2), 0.01);
}

TEST(CurvatureComb, growsWithItsFactor) {
    const SplineCurve curve = curveThrough(Rule::natural, {{0, 0}, {3, 3}, {6, 0}});
    EXPECT_NEAR(longestTooth(combOf(curve, 2.5)), 2.5 * longestTooth(combOf(curve)), 1e-12);
}

TEST(CurvatureComb, hasALineAlongItsTeethForEachSegment) {
    const Layer comb = combOf(curveThrough(Rule::catmullRom, {{0, 0}, {3, 3}, {6, 0}, {9, 1}}));
    EXPECT_EQ(std::ranges::count(comb.strokes, 1, &Stroke::series), 3);
}

TEST(CurvatureComb, breaksOffAtACuspAndKeepsTheRestInSight) {
    const std::vector<Points> cusp{{{0, 0}, {4, 4}, {0, 4}, {4, 0}}}; // its speed vanishes in the middle
    ASSERT_FALSE(curvature(cusp[0], 0.5));
    const Layer comb = curvatureCombLayer(cusp, cusp, 1);
    EXPECT_EQ(std::ranges::count(comb.strokes, 1, &Stroke::series), 2);
    const double first = distance(comb.strokes[0].path.points[0], comb.strokes[0].path.points[1]);
    EXPECT_GT(first, 0.001 * longestTooth(comb));
}

TEST(CurvatureComb, isEmptyWhereNothingBends) {
    EXPECT_TRUE(combOf(curveThrough(Rule::mirror, {{0, 0}, {1, 1}, {3, 3}})).strokes.empty());
    EXPECT_TRUE(combOf(curveThrough(Rule::mirror, {{1, 1}, {1, 1}})).strokes.empty());
    EXPECT_TRUE(combOf(SplineCurve{}).strokes.empty());
}

TEST(CurvatureComb, hasFewerTeethOnManySegments) {
    Points knots;
    for (int i = 0; i < 5000; ++i)
        knots.push_back({static_cast<double>(i), static_cast<double>(i % 2)});
    EXPECT_LT(combOf(curveThrough(Rule::natural, knots)).strokes.size(), 5000u * 4 + 1);
}

} // namespace
} // namespace kriva
