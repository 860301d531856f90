#include "core/sheets/elevation/elevation.h"
#include "tests/support/documents.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace kriva {
namespace {

using nlohmann::json;

ElevationCurve namedArch() {
    ElevationCurve curve;
    curve.name = "arch";
    curve.points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    curve.times = 1;
    return curve;
}

json reportOf(const ElevationCurve& curve) {
    return json::parse(test::reportOf(curve))["sheets"]["elevation"]["curves"][0];
}

// b_i' = i/4 b_(i-1) + (1 - i/4) b_i. B(1/4) = (29/32, 36/32) is 13/32 away from b_1', B(1/2) = (2, 3/2) is 1/2 away
// from b_2'.
TEST(ElevationReport, tellsTheElevatedPolygonAndItsGap) {
    const json report = reportOf(namedArch());
    EXPECT_EQ(report["degree"], 3);
    EXPECT_EQ(report["bounds"], json::parse("[0, 0, 4, 1.5]"));
    EXPECT_EQ(report["elevated"]["times"], 1);
    EXPECT_EQ(report["elevated"]["degree"], 4);
    EXPECT_EQ(report["elevated"]["points"], json::parse("[[0, 0], [0.75, 1.5], [2, 2], [3.25, 1.5], [4, 0]]"));
    EXPECT_NEAR(report["elevated"]["gap"], 0.5, 1e-15);
}

TEST(ElevationReport, withoutElevationGivesThePointsThemselves) {
    ElevationCurve curve = namedArch();
    curve.times = 0;
    EXPECT_EQ(reportOf(curve)["elevated"]["points"], json::parse("[[0, 0], [1, 2], [3, 2], [4, 0]]"));
    EXPECT_EQ(reportOf(curve)["elevated"]["degree"], 3);
}

TEST(ElevationReport, ofAnIncompleteCurveGivesNothingButItsName) {
    ElevationCurve curve = namedArch();
    curve.points.resize(1);
    EXPECT_EQ(reportOf(curve), json::parse(R"({"name": "arch", "incomplete": true})"));
}

TEST(ElevationReport, ofCoincidentPointsIsAPoint) {
    ElevationCurve curve = namedArch();
    curve.points.assign(4, {1, 1});
    const json report = reportOf(curve);
    EXPECT_EQ(report["length"], 0);
    EXPECT_EQ(report["bounds"], json::parse("[1, 1, 1, 1]"));
    EXPECT_EQ(report["elevated"]["gap"], 0);
}

TEST(ElevationResults, areTheNumbersOfTheReport) {
    const std::vector<Result> rows = results(Curve(namedArch()));
    ASSERT_EQ(rows.size(), 5u);
    EXPECT_EQ(std::get<int>(*rows[0].value), 3);
    EXPECT_EQ(std::get<Box>(*rows[2].value), (Box{0, 0, 4, 1.5}));
    EXPECT_EQ(std::get<int>(*rows[3].value), 4);
    EXPECT_EQ(rows[4].caption, Caption::gap);
}

} // namespace
} // namespace kriva
