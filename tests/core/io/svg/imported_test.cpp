#include "core/curve/limits.h"
#include "core/io/json/document_json.h"
#include "core/io/svg/imported.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

constexpr SheetIndex kElevationSheet = kSheetOf<ElevationCurve>;
constexpr SheetIndex kSplineSheet = kSheetOf<SplineCurve>;
constexpr SheetIndex kCombined = kSheetOf<CombinedCurve>;

const Path kCubic{{{0, 0}, {1, 2}, {3, 2}, {4, 0}}, {3}, false};
const Path kChain{{{0, 0}, {1, 2}, {3, 2}, {4, 0}, {5, 0}}, {3, 1}, false};

std::vector<Curve> curvesOf(const std::vector<ImportedPath>& paths, SheetIndex sheet, const Placing& placing = {}) {
    auto curves = importedCurves(paths, sheet, placing);
    EXPECT_TRUE(std::holds_alternative<std::vector<Curve>>(curves));
    return std::get<std::vector<Curve>>(std::move(curves));
}

TEST(ImportedCurves, areWhatTheSheetMakesOfThem) {
    EXPECT_EQ(std::get<ElevationCurve>(curvesOf({{"a", kCubic}}, kElevationSheet).front()).points, kCubic.points);
    EXPECT_EQ(std::get<ElevationCurve>(curvesOf({{"a", kChain}}, kElevationSheet).front()).points,
              (Points{{0, 0}, {4, 0}, {5, 0}}));
    EXPECT_EQ(std::get<CombinedCurve>(curvesOf({{"a", kChain}}, kCombined).front()).points,
              (Points{{0, 0}, {4, 0}, {5, 0}}));
    const Curve spline = curvesOf({{"Arc", kChain}}, kSplineSheet).front();
    EXPECT_EQ(nameOf(spline), "Arc");
    EXPECT_EQ(segmentsOf(std::get<SplineCurve>(spline)).front(), kCubic.points);
}

TEST(ImportedCurves, makeADocumentThatReadsBack) {
    const Path closed{{{0, 0}, {1, 0}, {1, 1}, {0, 0}}, {1, 2}, true};
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        Document document;
        document.sheets[sheet].curves = curvesOf({{"", kChain}, {"", closed}, {"", {{{7, 7}}, {}, false}}}, sheet);
        const auto read = readDocument(writeDocument(document));
        ASSERT_TRUE(std::holds_alternative<Document>(read)) << sheetName(sheet);
        EXPECT_EQ(std::get<Document>(read), document);
    }
}

TEST(ImportedCurves, areScaledFirstAndThenMoved) {
    const Curve curve = curvesOf({{"", kCubic}}, kElevationSheet, {2, {10, -1}}).front();
    EXPECT_EQ(std::get<ElevationCurve>(curve).points, (Points{{10, -1}, {12, 3}, {16, 3}, {18, -1}}));
}

TEST(ImportedCurves, areRefusedBeyondTheLimitsWithTheirPlace) {
    const auto faultOf = [](const std::vector<ImportedPath>& paths, SheetIndex sheet, const Placing& placing = {}) {
        return std::get<FileError>(importedCurves(paths, sheet, placing));
    };
    const Path many{Points(limits::kControlPoints + 1), {}, false};
    const FileError tooLong = faultOf({{"", kCubic}, {"", many}}, kElevationSheet);
    EXPECT_EQ(tooLong.problem, FileProblem::tooManyPointsInCurve);
    EXPECT_EQ(tooLong.curve, 2);
    EXPECT_EQ(tooLong.place, "");
    EXPECT_EQ(tooLong.numbers, (std::vector<double>{limits::kControlPoints, limits::kControlPoints + 1}));
    EXPECT_EQ(faultOf({{"Leaf", many}}, kElevationSheet).place, "Leaf");
    EXPECT_EQ(faultOf({{"", kCubic}}, kSplineSheet, {1e9, {}}).problem, FileProblem::coordinatesOutOfRange);
    const FileError tooMany =
        faultOf(std::vector<ImportedPath>(limits::kCurvesInSheet + 1, {"", kCubic}), kSplineSheet);
    EXPECT_EQ(tooMany.problem, FileProblem::tooManyCurves);
    EXPECT_EQ(tooMany.numbers, (std::vector<double>{1000, 1001}));
    EXPECT_EQ(tooMany.curve, 0);
}

} // namespace
} // namespace kriva
