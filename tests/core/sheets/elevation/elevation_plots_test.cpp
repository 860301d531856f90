#include "core/sheets/elevation/elevation.h"
#include "tests/support/unlimited.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

using test::plotsOf;
using test::tablesOf;

ElevationCurve cubic(int times) {
    ElevationCurve curve;
    curve.points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    curve.times = times;
    return curve;
}

TEST(ElevationPlots, showTheGapFallingLikeOneOverN) {
    const ElevationCurve curve = cubic(5);
    const std::vector<PlotGroup> groups = plotsOf(curve);
    ASSERT_EQ(groups.size(), 2U);
    EXPECT_EQ(groups[0].plots[0].lines.size(), 4U); // B_0 to B_3
    const Plot& gap = groups[1].plots[0];
    EXPECT_TRUE(gap.x.isLogarithmic && gap.y.isLogarithmic);
    EXPECT_EQ(gap.at, 8);
    EXPECT_NEAR(valueAt(gap.lines[0], 8).value(), elevate(curve).gap, 1e-15);
    const Points& gaps = gap.lines[0].path.points;
    EXPECT_EQ(gaps.front().x, 3);
    EXPECT_EQ(gaps.back().x, 100); // 97 elevations
    EXPECT_NEAR(gaps.back().y, elevate(cubic(97)).gap, 1e-15);
    const Points& reference = gap.lines[1].path.points;
    EXPECT_NEAR(reference.front().x * reference.front().y, reference.back().x * reference.back().y, 1e-12);
    EXPECT_EQ(reference.back(), gaps.back());
    EXPECT_NEAR(valueAt(gap.lines[1], 8).value(), 100 * gaps.back().y / 8, 1e-12) << "also between its ends";
    EXPECT_EQ(lookedAt(gap, 8.4), 8) << "there is no degree between";
    EXPECT_EQ(lookedAt(gap, 0.2), 3);
}

TEST(ElevationPlots, haveNoGapOfALine) {
    ElevationCurve line;
    line.points = {{0, 0}, {1, 1}};
    EXPECT_TRUE(plotsOf(line)[1].plots[0].lines.empty());
    line.points.pop_back();
    EXPECT_TRUE(plotsOf(line).empty());
}

TEST(ElevationTables, tellHowTheLastElevationMadeItsPoints) {
    const std::vector<Table> tables = tablesOf(cubic(2));
    ASSERT_EQ(tables.size(), 1U);
    const Table& table = tables[0];
    const Points after = elevate(cubic(2)).polygon;
    ASSERT_EQ(table.rows.size(), after.size());
    for (std::size_t i = 0; i < after.size(); ++i) {
        const std::vector<TableCell>& row = table.rows[i];
        const double part = std::get<double>(row[1].value);
        const Point made = i == 0 ? std::get<Point>(row[4].value)
                           : i + 1 == after.size()
                               ? std::get<Point>(row[2].value)
                               : lerp(std::get<Point>(row[4].value), std::get<Point>(row[2].value), part);
        EXPECT_NEAR(distance(made, after[i]), 0, 1e-15) << i;
        EXPECT_EQ(std::get<Point>(row[5].value), after[i]);
    }
    EXPECT_TRUE(tablesOf(cubic(0)).empty());
}

} // namespace
} // namespace kriva
