#include "core/curve/json/json_writer.h"
#include "core/document/document.h"
#include "core/document/limit_check.h"
#include "core/document/report.h"
#include "core/sheets/combined/combined.h"
#include "tests/support/sheet_curves.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace kriva {
namespace {

using ::testing::HasSubstr;

std::string reportOf(const CombinedCurve& curve) {
    JsonWriter json(JsonWriter::Digits::shortest, 0);
    json.beginObject();
    reportCurve(json, curve);
    json.endObject();
    return std::move(json).take();
}

TEST(CombinedReport, tellsRunsJoinsAndPath) {
    CombinedCurve curve;
    curve.points = {{0, 0}, {1, 1}, {2, 2}, {1, 4}, {0, 5}};
    curve.degree = 1;
    const std::string report = reportOf(curve);
    EXPECT_THAT(report, HasSubstr(R"("bounds": [0, 0, 2.125, 5])"));
    EXPECT_THAT(report,
                HasSubstr(R"({"first": 3, "last": 4, "direction": -1, "degree": 1, "basis": "power", "nodes": [], )"
                          R"("coefficients": [5, -1], "rms": 0, "maxError": 0, "start": [1, 4], "end": [0, 5], )"
                          R"("startSlope": -1, "endSlope": -1})"));
    EXPECT_THAT(report, HasSubstr(R"({"afterRun": 0, "kind": "quadratic", "points": [[2, 2], [2.5, 2.5], [1, 4]]})"));
    EXPECT_THAT(report, HasSubstr(R"("path": [[[0, 0], [2, 2]], [[2, 2], [2.5, 2.5], [1, 4]], [[1, 4], [0, 5]]])"));
    EXPECT_THAT(report, HasSubstr(R"("slopeVariation": 0})"));
}

TEST(CombinedReport, hasNoSlopesAtASinglePoint) {
    CombinedCurve curve;
    curve.points = {{3, 4}};
    EXPECT_THAT(reportOf(curve), HasSubstr(R"("start": [3, 4], "end": [3, 4], "startSlope": null, "endSlope": null})"));
    EXPECT_THAT(reportOf(curve), HasSubstr(R"("joins": [], "path": [], "largestKink": 0, "bendingEnergy": 0)"));
}

TEST(CombinedReport, isRefusedWhereItsInterpolatedRunsHaveTooManyPairsOfPoints) {
    CombinedCurve curve; // 201 points that go right and 200 that come back from the last one of these
    curve.method = CombinedCurve::Method::interpolation;
    for (int i = 0; i <= 400; ++i)
        curve.points.push_back({i <= 200 ? i : 400.5 - i, static_cast<double>(i)});
    EXPECT_EQ(interpolatedPairs(curve), 201u * 201 + 200 * 200);
    Document document;
    auto& curves = document.sheets[*sheetNamed("combined")].curves;
    const std::size_t most = limits::kInterpolatedPairs / interpolatedPairs(curve);
    curves.assign(most, Curve(curve));
    EXPECT_FALSE(reportLimitError(document));
    curves.emplace_back(curve);
    const std::optional<FileError> error = reportLimitError(document);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->place, "sheets.combined.curves");
    EXPECT_EQ(error->problem, FileProblem::tooManyPairs);
    EXPECT_FALSE(reportLimitError(document, sheetNamed("spline"))) << "another sheet is asked for";
    for (Curve& c : curves)
        std::get<CombinedCurve>(c).method = CombinedCurve::Method::pairs;
    EXPECT_FALSE(reportLimitError(document));
}

TEST(CombinedReport, isRefusedWhereItsPathsHaveTooManyPieces) {
    CombinedCurve curve; // it turns round at each step
    for (int i = 0; i < 100'000; ++i)
        curve.points.push_back({static_cast<double>(i % 2), static_cast<double>(i)});
    EXPECT_EQ(pathPieces(curve), 50'000u + 49'999);
    Document document;
    const SheetIndex sheet = *sheetNamed("combined");
    document.sheets[sheet].curves = test::curves({curve, curve});
    EXPECT_FALSE(outputLimitError(document.sheets[sheet], sheet, Output::figure)) << "199,998";
    CombinedCurve small;
    small.points = {{0, 0}, {1, 1}, {2, 0}, {1, 3}};
    EXPECT_EQ(pathPieces(small), 3u) << "two runs and a join";
    small.method = CombinedCurve::Method::pairs;
    EXPECT_EQ(pathPieces(small), 3u) << "two pairs in one run, none in the other, a join";
    document.sheets[sheet].curves.emplace_back(small);
    const std::optional<FileError> error = reportLimitError(document);
    ASSERT_TRUE(error) << "200,001";
    EXPECT_EQ(error->place, "sheets.combined.curves");
    EXPECT_EQ(error->problem, FileProblem::tooManyPathPieces);
    EXPECT_EQ(error->numbers, (std::vector<double>{200'000, 200'001}));
}

TEST(CombinedReport, tellsPeopleEveryRun) {
    CombinedCurve curve;
    curve.points = {{0, 0}, {1, 1}, {0, 3}};
    const std::vector<Result> rows = results(Curve(curve));
    const auto isOf = [](Caption caption, std::string_view index) {
        return [=](const Result& row) { return row.caption == caption && row.index == index; };
    };
    EXPECT_EQ(std::ranges::count_if(rows, isOf(Caption::runCoefficients, "0")), 1);
    EXPECT_EQ(std::ranges::count_if(rows, isOf(Caption::runCoefficients, "1")), 1);
    EXPECT_EQ(std::ranges::count_if(rows, isOf(Caption::runCoefficients, "2")), 0);
}

} // namespace
} // namespace kriva
