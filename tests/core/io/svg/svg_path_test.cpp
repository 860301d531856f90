#include "core/io/svg/svg_path.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

/// One unit is one millimetre and the margin is zero.
const Page kPage = pageOf({0, 0, 100, 100}, 1, 0);

std::string dataOf(const Path& path) {
    return pathData(path, kPage, decimalsOf(kPage));
}

TEST(PathData, writesDegreesOneToThreeExactly) {
    EXPECT_EQ(dataOf(polyline(Points{{0, 100}, {10, 90}, {0, 50}})), "M 0,0 L 10,10 L 0,50");
    EXPECT_EQ(dataOf(singleCurve(Points{{0, 0}, {50, 100}, {100, 0}})), "M 0,100 Q 50,0 100,100");
    EXPECT_EQ(dataOf(singleCurve(Points{{0, 0}, {1, 2}, {3, 4}, {5, 6}})), "M 0,100 C 1,98 3,96 5,94");
}

TEST(PathData, joinsPiecesOfDifferentDegrees) {
    const Path path = chain({{{0, 100}, {50, 0}, {100, 100}}, {{100, 100}, {0, 100}}}, true);
    EXPECT_EQ(dataOf(path), "M 0,0 Q 50,100 100,0 L 0,0 Z");
}

TEST(PathData, followsHigherDegreesWithCubics) {
    const std::string data = dataOf(singleCurve(Points{{0, 0}, {0, 90}, {50, -50}, {90, 80}, {100, 0}}));
    EXPECT_EQ(data.substr(0, 9), "M 0,100 C");
    EXPECT_EQ(data.substr(data.rfind(' ')), " 100,100");
    EXPECT_EQ(data.find_first_of("LQZe"), std::string::npos);
}

TEST(PathData, isEmptyWithoutAPiece) {
    EXPECT_EQ(dataOf({}), "");
    EXPECT_EQ(dataOf(polyline(Points{{1, 2}})), "");
    EXPECT_EQ(dataOf(singleCurve(Points{{1, 2}})), "");
}

TEST(PathData, keepsCoordinatesToThirteenDigitsOfThePage) {
    const Page page = pageOf({0, 0, 3, 1});
    EXPECT_EQ(decimalsOf(page), 11);
    EXPECT_EQ(pathData(polyline(Points{{0, 1}, {1.0 / 7, 1}}), page, decimalsOf(page)), "M 6,6 L 11.14285714286,6");
    EXPECT_EQ(pathData(polyline(Points{{0, 1}, {1.0 / 7, 1}}), page, 2), "M 6,6 L 11.14,6");
    EXPECT_EQ(decimalsOf(pageOf({0, 0, 1, 1}, 1e15)), 0);
}

} // namespace
} // namespace kriva
