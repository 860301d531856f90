#include "core/document/methods.h"
#include "core/sheets/spline/spline_measures.h"
#include "tests/support/unlimited.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace kriva {
namespace {

using test::compareMethods;

TEST(CompareMethods, tellsWhichIsBest) {
    CombinedCurve curve;
    curve.points = {{0, 0}, {1, 2}, {2, 2.5}, {3, 2}, {4, 0.5}, {3.5, -1}, {2, -2}, {1, -1.8}};
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
    curve.points.resize(1);
    EXPECT_TRUE(compareMethods(curve).rows.empty());
}

} // namespace
} // namespace kriva
