#include "core/sheets/combined/combined.h"
#include "core/sheets/spline/spline_measures.h"
#include "tests/support/unlimited.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace kriva {
namespace {

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

TEST(CombinedPlots, leaveOutWhatTheLimitsForbid) {
    CombinedCurve curve;
    for (int i = 0; i < 202; ++i)
        curve.points.push_back({i / 10.0, static_cast<double>(i % 3)});
    EXPECT_EQ(plotsOf(curve)[0].plots.size(), 1U);
}

} // namespace
} // namespace kriva
