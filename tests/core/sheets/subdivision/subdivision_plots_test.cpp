#include "core/bezier/evaluate.h"
#include "core/sheets/subdivision/subdivision.h"
#include "tests/support/unlimited.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

using test::plotsOf;
using test::tablesOf;

SubdivisionCurve curveOf(const Points& points, double t) {
    SubdivisionCurve curve;
    curve.points = points;
    curve.multiplicity.assign(points.size(), 1);
    curve.t = t;
    return curve;
}

Point pointIn(const Table& table, std::size_t row, std::size_t column) {
    return std::get<Point>(table.rows[row][column].value);
}

// The example of the Slovenian text: its table ends in (7/2, 3/2).
TEST(SubdivisionTables, tellTheSchemeOfTheSources) {
    const std::vector<Table> tables = tablesOf(curveOf({{0, 0}, {0, 2}, {8, 2}, {4, 0}}, 0.5));
    ASSERT_EQ(tables.size(), 3U);
    const Table& scheme = tables[0];
    ASSERT_EQ(scheme.columns.size(), 5U); // i and four levels
    EXPECT_EQ(pointIn(scheme, 0, 1), (Point{0, 0}));
    EXPECT_EQ(pointIn(scheme, 1, 2), (Point{4, 2}));
    EXPECT_EQ(pointIn(scheme, 0, 3), (Point{2, 1.5}));
    EXPECT_EQ(pointIn(scheme, 0, 4), (Point{3.5, 1.5}));
    EXPECT_EQ(scheme.rows[3][2].value.index(), 0U); // nothing below the triangle
    const Table& halves = tables[2];
    EXPECT_EQ(pointIn(halves, 3, 1), (Point{3.5, 1.5}));
    EXPECT_EQ(pointIn(halves, 0, 2), (Point{3.5, 1.5}));
}

TEST(SubdivisionTables, weighControlPointsAtT) {
    SubdivisionCurve curve = curveOf({{0, 0}, {1, 2}, {3, 1}}, 0.3);
    curve.multiplicity = {1, 2, 1};
    const Table table = tablesOf(curve)[1];
    ASSERT_EQ(table.rows.size(), 4U);
    Point sum;
    for (const std::vector<TableCell>& row : table.rows)
        sum = sum + std::get<double>(row[2].value) * (std::get<Point>(row[1].value) - Point{});
    const Point there = evaluate(controlPolygon(curve), 0.3);
    EXPECT_NEAR(sum.x, there.x, 1e-15);
    EXPECT_NEAR(sum.y, there.y, 1e-15);
    EXPECT_EQ(plotsOf(curve).front().plots.front().lines.size(), 4U);
    EXPECT_EQ(plotsOf(curve).front().plots.front().at, 0.3);
}

TEST(SubdivisionTables, haveTheBlossomsSchemeWhereItIsAskedFor) {
    SubdivisionCurve curve = curveOf({{0, 0}, {0, 2}, {8, 2}, {4, 0}}, 0.5);
    curve.blossom = std::vector{0.0, 0.5, 1.0};
    const std::vector<Table> tables = tablesOf(curve);
    ASSERT_EQ(tables.size(), 4U);
    EXPECT_EQ(pointIn(tables[3], 0, 4), *subdivide(curve).blossom);
}

TEST(SubdivisionTables, areNoneWhileTheCurveIsIncomplete) {
    EXPECT_TRUE(tablesOf(curveOf({{1, 1}}, 0.5)).empty());
    EXPECT_TRUE(plotsOf(curveOf({{1, 1}}, 0.5)).empty());
}

} // namespace
} // namespace kriva
