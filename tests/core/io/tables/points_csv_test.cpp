#include "core/io/tables/points_csv.h"
#include "tests/support/sheet_curves.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

TEST(PointsCsv, hasThePointsOfTheShownCurves) {
    Sheet sheet;
    sheet.curves =
        test::curves({ElevationCurve{"", {{0, 0.1}, {1e-9, -2}}, 0, {}, {}},
                      ElevationCurve{"", {{3, 3}}, 0, {}, {false}}, ElevationCurve{"", {{4, 4}}, 0, {}, {}}});
    EXPECT_EQ(writePointsCsv(sheet), "curve,point,x,y\n0,0,0,0.1\n0,1,1e-09,-2\n2,0,4,4\n");
    EXPECT_EQ(writePointsCsv(sheet, 1), "curve,point,x,y\n1,0,3,3\n");
    EXPECT_EQ(writePointsCsv(Sheet()), "curve,point,x,y\n");
}

} // namespace
} // namespace kriva
