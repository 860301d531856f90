#include "core/document/methods.h"
#include "core/sheets/combined/combined.h"
#include "core/sheets/spline/spline_measures.h"
#include "tests/support/unlimited.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace kriva {
namespace {

using test::compareMethods;
using test::plotsOf;
using test::tablesOf;

CombinedCurve arch() {
    CombinedCurve curve;
    curve.points = {{0, 0}, {1, 2}, {2, 2.5}, {3, 2}, {4, 0.5}, {3.5, -1}, {2, -2}, {1, -1.8}};
    return curve;
}

TEST(CombinedPlots, showInterpolationAboveApproximation) {
    const CombinedCurve curve = arch();
    const std::vector<PlotGroup> groups = plotsOf(curve);
    ASSERT_EQ(groups.size(), 2U);
    ASSERT_EQ(groups[0].plots.size(), 2U);
    EXPECT_EQ(groups[0].plots[0].caption, Caption::interpolation);
    EXPECT_EQ(groups[0].plots[0].x, groups[0].plots[1].x);
    // The interpolation passes through all points of its run.
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(valueAt(groups[0].plots[0].lines[0], curve.points[i].x).value(), curve.points[i].y, 1e-12);
    EXPECT_EQ(groups[0].plots[0].given, curve.points);
}

TEST(CombinedPlots, showTheSlopes) {
    CombinedCurve curve = arch();
    const Plot slopes = plotsOf(curve)[1].plots[1];
    const Combined combined = combine(curve);
    for (std::size_t i = 0; i < combined.runs.size(); ++i) {
        EXPECT_NEAR(valueAt(slopes.lines[i], combined.runs[i].start.x).value(), *combined.runs[i].startSlope, 1e-12);
        EXPECT_NEAR(valueAt(slopes.lines[i], combined.runs[i].end.x).value(), *combined.runs[i].endSlope, 1e-12);
    }
}

TEST(CombinedTables, tellRunsAndJoins) {
    const CombinedCurve curve = arch();
    const Combined combined = combine(curve);
    const std::vector<Table> tables = tablesOf(curve);
    ASSERT_EQ(tables.size(), 2U);
    ASSERT_EQ(tables[0].rows.size(), combined.runs.size());
    for (std::size_t i = 0; i < combined.runs.size(); ++i) {
        EXPECT_EQ(std::get<double>(tables[0].rows[i][3].value), combined.runs[i].rms);
        for (std::size_t k = 0; k < combined.runs[i].coefficients.size(); ++k)
            EXPECT_EQ(std::get<double>(tables[0].rows[i][5 + k].value), combined.runs[i].coefficients[k]);
    }
    ASSERT_EQ(tables[1].rows.size(), combined.joins.size());
    EXPECT_EQ(std::get<Point>(tables[1].rows[0][2].value), combined.joins[0].points[0]);
}

TEST(CombinedTables, nameTheNodesOfTheBasis) {
    CombinedCurve curve = arch();
    EXPECT_TRUE(std::ranges::none_of(tablesOf(curve)[0].columns, [](const auto& c) { return c.letter == "x"; }));
    curve.basis = CombinedCurve::Basis::newton;
    const Combined combined = combine(curve);
    const Table table = tablesOf(curve)[0];
    const auto first = std::ranges::find(table.columns, "x", &TableColumn::letter);
    ASSERT_NE(first, table.columns.end());
    const auto column = static_cast<std::size_t>(first - table.columns.begin());
    for (std::size_t i = 0; i < combined.runs.size(); ++i)
        for (std::size_t k = 0; k < combined.runs[i].nodes.size(); ++k)
            EXPECT_EQ(std::get<double>(table.rows[i][column + k].value), combined.runs[i].nodes[k]);
}

TEST(CompareMethods, tellsWhichIsBest) {
    const CombinedCurve curve = arch();
    const Table table = compareMethods(curve);
    ASSERT_EQ(table.rows.size(), 7U); // interpolation, four degrees, pairs, spline
    const auto number = [&](std::size_t row, std::size_t column) {
        return std::get<double>(table.rows[row][column].value);
    };
    EXPECT_EQ(number(0, 2), 0);            // interpolation has no residual
    EXPECT_GT(number(1, 2), number(2, 2)); // a higher degree comes closer
    EXPECT_GE(number(2, 2), number(3, 2));
    EXPECT_TRUE(table.rows[0][2].isBest);
    EXPECT_FALSE(table.rows[1][2].isBest);
    SplineCurve spline;
    spline.rule = SplineCurve::Rule::natural;
    for (const Point p : curve.points)
        spline.knots.push_back({p, SplineKnot::Join::automatic, {}, {}});
    EXPECT_EQ(number(6, 6), measure(spline).length);
    EXPECT_EQ(table.rows[6][4].value.index(), 0U); // a spline is no graph
    for (std::size_t column = 2; column < table.columns.size(); ++column)
        EXPECT_TRUE(std::ranges::any_of(table.rows, [&](const auto& row) { return row[column].isBest; })) << column;
}

TEST(CompareMethods, leavesOutWhatTheLimitsForbid) {
    CombinedCurve curve;
    for (int i = 0; i < 202; ++i)
        curve.points.push_back({i / 10.0, static_cast<double>(i % 3)});
    const Table table = compareMethods(curve);
    EXPECT_EQ(table.rows[0][2].value.index(), 0U);
    EXPECT_GT(std::get<double>(table.rows[1][2].value), 0);
    EXPECT_EQ(plotsOf(curve)[0].plots.size(), 1U);
    curve.points.resize(1);
    EXPECT_TRUE(compareMethods(curve).rows.empty());
}

} // namespace
} // namespace kriva
