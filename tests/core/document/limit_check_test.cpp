#include "core/curve/limits.h"
#include "core/document/limit_check.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

constexpr SheetIndex kCombined = kSheetOf<CombinedCurve>;

CombinedCurve wave(std::size_t points) {
    CombinedCurve curve;
    for (std::size_t i = 0; i < points; ++i)
        curve.points.push_back({static_cast<double>(i), static_cast<double>(i % 2)});
    return curve;
}

TEST(LimitError, ofAnEditHasNumbersAndNoPlace) {
    CombinedCurve curve = wave(300);
    EXPECT_FALSE(limitErrorWith({}, {}, Curve(curve)));
    curve.method = CombinedCurve::Method::interpolation;
    const FileError error = limitErrorWith({}, {}, Curve(curve)).value();
    EXPECT_EQ(error.problem, FileProblem::tooManyPointsInRun);
    EXPECT_EQ(error.numbers, (std::vector<double>{201, 300}));
    EXPECT_EQ(error.place, "");
}

TEST(LimitError, ofAnInterpolationTellsTheLongestRun) {
    CombinedCurve curve = wave(250);
    curve.method = CombinedCurve::Method::interpolation;
    curve.points.push_back({-1, 0}); // turns back
    for (int i = 2; i < 290; ++i)
        curve.points.push_back({static_cast<double>(-i), 0});
    EXPECT_EQ(limitErrorWith({}, {}, Curve(curve)).value().numbers, (std::vector<double>{201, 289}));
}

TEST(LimitError, ofACurveTellsItsPoints) {
    ElevationCurve curve;
    curve.points.assign(limits::kControlPoints + 5, {1, 2});
    const FileError error = limitErrorWith({}, {}, Curve(curve)).value();
    EXPECT_EQ(error.problem, FileProblem::tooManyPointsInCurve);
    EXPECT_EQ(error.numbers, (std::vector<double>{201, 206}));
}

TEST(LimitError, ofCoordinatesTellsTheirRange) {
    ElevationCurve curve;
    curve.points = {{0, 0}, {0, 2e9}};
    const FileError error = limitErrorWith({}, {}, Curve(curve)).value();
    EXPECT_EQ(error.problem, FileProblem::coordinatesOutOfRange);
    EXPECT_EQ(error.numbers, (std::vector<double>{-1e9, 1e9}));
}

TEST(LimitError, ofASheetTellsItsCurves) {
    Sheet sheet;
    sheet.curves.assign(limits::kCurvesInSheet, emptyCurve(kCombined));
    EXPECT_FALSE(sheetLimitError(sheet));
    EXPECT_EQ(limitErrorWith(sheet, {}, emptyCurve(kCombined)).value().numbers, (std::vector<double>{1000, 1001}));
    EXPECT_FALSE(limitErrorWith(sheet, 0, emptyCurve(kCombined)));
}

} // namespace
} // namespace kriva
