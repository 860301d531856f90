#include "core/document/report.h"
#include "core/sheets/subdivision/subdivision.h"
#include "tests/support/documents.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace kriva {
namespace {

using nlohmann::json;

SubdivisionCurve namedSplit() {
    SubdivisionCurve curve;
    curve.name = "arch";
    curve.points = {{0, 0}, {2, 4}, {4, 0}};
    curve.multiplicity = {1, 3, 1};
    curve.t = 0.25;
    curve.levels = 2;
    curve.blossom = {0, 0.25, 0.5, 1};
    return curve;
}

json reportOf(const SubdivisionCurve& curve) {
    return json::parse(test::reportOf(curve))["sheets"]["subdivision"]["curves"][0];
}

TEST(SubdivisionReport, listsSchemesUpToALimit) {
    EXPECT_EQ(reportedSchemePoints(namedSplit()), 5u + 4 + 3 + 2 + 1);
    EXPECT_EQ(reportedSchemePoints({}), 0u);
    SubdivisionCurve largest = namedSplit();
    largest.multiplicity = {1, 199, 1};
    largest.blossom.reset();
    const std::size_t most = limits::kReportedSchemePoints / (201 * 202 / 2);
    Document document;
    auto& curves = document.sheets[*sheetNamed("subdivision")].curves;
    curves.assign(most, Curve(largest));
    EXPECT_FALSE(reportJsonLimitError(document));
    curves.emplace_back(largest);
    const std::optional<FileError> error = reportJsonLimitError(document);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->problem, FileProblem::tooManySchemePoints);
    EXPECT_EQ(error->place, "sheets.subdivision.curves");
    EXPECT_TRUE(std::holds_alternative<FileError>(reportJson(document, "a.kriva")));
    EXPECT_FALSE(reportLimitError(document)) << "people are told only what schemes end in";
    EXPECT_FALSE(reportJsonLimitError(document, sheetNamed("spline"))) << "another sheet is asked for";
}

// All numbers here are dyadic fractions: worked out by hand, met exactly.
TEST(SubdivisionReport, tellsWhatOneCutTells) {
    const json report = reportOf(namedSplit());
    EXPECT_EQ(report["name"], "arch");
    EXPECT_EQ(report["degree"], 4);
    EXPECT_EQ(report["bounds"], json::parse("[0, 0, 4, 3.5]"));
    EXPECT_EQ(report["point"], json::parse("[1.375, 2.71875]"));
    EXPECT_EQ(report["derivative"], json::parse("[3.5, 6.5]"));
    EXPECT_EQ(report["triangle"].size(), 5u);
    EXPECT_EQ(report["triangle"][0].size(), 5u);
    EXPECT_EQ(report["triangle"][3], json::parse("[[1.15625, 2.3125], [2.03125, 3.9375]]"));
    EXPECT_EQ(report["left"][1], json::parse("[0.5, 1]"));
    EXPECT_EQ(report["right"][3], json::parse("[2.5, 3]"));
    EXPECT_EQ(report["pieces"].size(), 4u);
    EXPECT_EQ(report["pieces"][2][0], report["point"]);
    EXPECT_EQ(report["pieces"][1][1], json::parse("[0.76416015625, 1.52783203125]"));
    EXPECT_EQ(report["blossom"], json::parse("[2, 4]"));
}

TEST(SubdivisionReport, hasABlossomOnlyIfTheDocumentAsks) {
    SubdivisionCurve curve = namedSplit();
    curve.blossom.reset();
    EXPECT_FALSE(reportOf(curve).contains("blossom"));
}

TEST(SubdivisionReport, writesNullForABlossomBeyondTheRangeOfDoubles) {
    SubdivisionCurve curve;
    curve.points = {{0, 0}, {1, 1}};
    curve.multiplicity = {100, 100};
    curve.blossom.emplace(199, 1e9);
    EXPECT_TRUE(reportOf(curve)["blossom"][0].is_null());
}

TEST(SubdivisionReport, ofAnIncompleteCurveGivesNothingButItsName) {
    SubdivisionCurve curve;
    curve.name = "one point";
    curve.points = {{1, 1}};
    curve.multiplicity = {5};
    EXPECT_EQ(reportOf(curve), json::parse(R"({"name": "one point", "incomplete": true})"));
}

TEST(SubdivisionResults, areTheNumbersOfTheReport) {
    const std::vector<Result> rows = results(Curve(namedSplit()));
    ASSERT_EQ(rows.size(), 9u);
    EXPECT_EQ(std::get<int>(*rows[0].value), 4);
    EXPECT_EQ(rows[3].caption, Caption::pointAtT);
    EXPECT_EQ(std::get<Point>(*rows[3].value), (Point{1.375, 2.71875}));
    EXPECT_EQ(std::get<Points>(*rows[5].value).size(), 5u);
    EXPECT_EQ(std::get<int>(*rows[7].value), 4);
    EXPECT_EQ(rows[8].caption, Caption::blossom);
}

} // namespace
} // namespace kriva
