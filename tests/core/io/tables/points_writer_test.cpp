#include "core/curve/limits.h"
#include "core/io/tables/points_reader.h"
#include "core/io/tables/points_writer.h"
#include "tests/support/sheet_curves.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

TEST(PointsWriter, hasThePointsOfTheShownCurves) {
    Sheet sheet;
    sheet.curves =
        test::curves({ElevationCurve{"", {{0, 0.1}, {1e-9, -2}}, 0, {}, {}},
                      ElevationCurve{"", {{3, 3}}, 0, {}, {false}}, ElevationCurve{"", {{4, 4}}, 0, {}, {}}});
    EXPECT_EQ(writePointsCsv(sheet), "curve,point,x,y\n0,0,0,0.1\n0,1,1e-09,-2\n2,0,4,4\n");
    EXPECT_EQ(writePointsCsv(sheet, 1), "curve,point,x,y\n1,0,3,3\n");
    EXPECT_EQ(writePointsCsv(Sheet()), "curve,point,x,y\n");
}

TEST(PointsWriter, writesTablesThatComeBackBitForBit) {
    const Points points{{0.1, -1.0 / 3}, {1e-300, limits::kNumber}, {0, 12345.678}};
    for (const char* sign : {".", ","})
        EXPECT_EQ(std::get<std::vector<Points>>(readPointsTable(writePointsTable(points, sign))),
                  std::vector<Points>{points});
    EXPECT_EQ(writePointsTable(Points{{1, 2.5}, {-3, 0}}, "."), "1\t2.5\n-3\t0");
    EXPECT_EQ(writePointsTable(Points{{1, 2.5}, {-3, 0}}, ","), "1\t2,5\n-3\t0");
}

} // namespace
} // namespace kriva
