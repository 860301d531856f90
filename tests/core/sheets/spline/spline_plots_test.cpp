#include "core/bezier/evaluate.h"
#include "core/bezier/measures/curvature.h"
#include "core/sheets/spline/spline.h"
#include "core/sheets/spline/spline_measures.h"
#include "tests/support/unlimited.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

using test::plotsOf;
using test::tablesOf;

SplineCurve chainThrough(const Points& points) {
    SplineCurve curve;
    for (const Point p : points)
        curve.knots.push_back({p, SplineKnot::Join::automatic, {}, {}});
    return curve;
}

const SplineCurve kChain = chainThrough({{0, 0}, {3, 2}, {5, 0}, {6, 4}});

TEST(SplineTables, tellCoefficientsThatGiveTheSegments) {
    const Table table = tablesOf(kChain)[0];
    const std::vector<Points> segments = segmentsOf(kChain);
    ASSERT_EQ(table.rows.size(), segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        Vector sum;
        for (std::size_t k = 4; k >= 1; --k)
            sum = std::get<Vector>(table.rows[i][k].value) + 0.3 * sum;
        EXPECT_NEAR(distance(Point{} + sum, evaluate(segments[i], 0.3)), 0, 1e-14);
    }
}

TEST(SplineTables, compareAllRulesOnTheSameKnots) {
    const Table table = tablesOf(kChain)[1];
    ASSERT_EQ(table.rows.size(), 4U);
    SplineCurve natural = kChain;
    natural.rule = SplineCurve::Rule::natural;
    EXPECT_EQ(std::get<double>(table.rows[1][1].value), measure(natural).length);
    EXPECT_EQ(std::get<double>(table.rows[1][2].value), *measure(natural).bendingEnergy);
    for (std::size_t column = 1; column <= 3; ++column) {
        double least = std::numeric_limits<double>::infinity();
        for (const std::vector<TableCell>& row : table.rows)
            least = std::min(least, std::get<double>(row[column].value));
        for (const std::vector<TableCell>& row : table.rows)
            EXPECT_EQ(row[column].isBest, std::get<double>(row[column].value) == least);
    }
}

TEST(SplineTables, haveNoRulesForParabolasAndNothingForOneKnot) {
    SplineCurve curve = kChain;
    curve.degree = 2;
    EXPECT_EQ(tablesOf(curve).size(), 1U);
    EXPECT_TRUE(tablesOf(chainThrough({{1, 1}})).empty());
    EXPECT_TRUE(plotsOf(chainThrough({{1, 1}})).empty());
}

TEST(SplinePlots, drawTheHodograph) {
    const Plot plot = plotsOf(kChain).front().plots.front();
    EXPECT_TRUE(plot.isToScale);
    const std::vector<Points> segments = segmentsOf(kChain);
    ASSERT_EQ(plot.lines.size(), segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Vector velocity = derivative(segments[i], 0.7);
        EXPECT_NEAR(distance(evaluate(plot.lines[i].path.points, 0.7), Point{} + velocity), 0, 1e-13);
    }
}

} // namespace
} // namespace kriva
