#include "core/bezier/evaluate.h"
#include "core/document/report.h"
#include "tests/core/sheets/spline/spline_values.h"
#include "tests/support/sheet_curves.h"

#include <gmock/gmock.h>

namespace kriva {
namespace {

using Rule = SplineCurve::Rule;
using ::testing::HasSubstr;

std::string reportOf(const SplineCurve& curve) {
    Document document;
    document.sheets[*sheetNamed("spline")].curves = test::curves({curve});
    const auto report = reportJson(document, "chain.kriva", sheetNamed("spline"));
    EXPECT_TRUE(std::holds_alternative<std::string>(report));
    return std::holds_alternative<std::string>(report) ? std::get<std::string>(report) : "";
}

TEST(SplineReport, tellsTheControlPointsOfEverySegment) {
    SplineCurve arch = test::curveThrough(Rule::clamped, {{0, 0}, {3, 0}});
    arch.startDerivative = Vector{0, 3};
    arch.endDerivative = Vector{0, -3};
    EXPECT_THAT(reportOf(arch), HasSubstr(R"("points": [[0, 0], [0, 1], [3, 1], [3, 0]], "length": 3.66382663695)"));
    EXPECT_THAT(reportOf(arch), HasSubstr(R"("bounds": [0, 0, 3, 0.75])"));
}

TEST(SplineReport, tellsHowKnotsMeet) {
    const std::string report = reportOf(test::curveThrough(Rule::natural, {{0, 0}, {3, 3}, {6, 0}}));
    EXPECT_THAT(report, HasSubstr(R"("knots": [{"continuity": "end"}, {"continuity": "C2"}, {"continuity": "end"}])"));
}

// One extremum where the two segments meet: the curvature rises up to the knot and falls behind it.
TEST(SplineReport, countsExtremaAtKnotsOfOneCurvature) {
    const SplineCurve arch = test::curveThrough(Rule::natural, {{0, 0}, {3, 3}, {6, 0}});
    EXPECT_THAT(reportOf(arch), HasSubstr(R"("curvatureExtrema": 1)"));
    EXPECT_THAT(reportOf(arch), HasSubstr(R"("bendingEnergy": 1.061081524)"));
}

TEST(SplineReport, countsTheExtremumAtTheFirstKnotOfAClosedChain) {
    const Points square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    for (const Rule rule : {Rule::natural, Rule::catmullRom})
        EXPECT_THAT(reportOf(test::curveThrough(rule, square, true)), HasSubstr(R"("curvatureExtrema": 8)"));
}

TEST(SplineReport, tellsNoBendingEnergyWhereItDiverges) {
    SplineCurve cusp = test::curveThrough(Rule::mirror, {{0, 0}, {1, 0}});
    cusp.knots[0] = test::heldKnot({0, 0}, SplineKnot::Join::corner, {}, Point{1, 1});
    cusp.knots[1] = test::heldKnot({1, 0}, SplineKnot::Join::corner, Point{0, 1}, {});
    EXPECT_THAT(reportOf(cusp), HasSubstr(R"("bendingEnergy": null)"));
}

// Control points far from the origin are rounded to its distance; what is measured is not.
TEST(SplineReport, measuresTheSameFarFromTheOrigin) {
    const auto measures = [](const std::string& report) {
        const auto between = [&](std::string_view from, std::string_view to) {
            const std::size_t start = report.find(from);
            return report.substr(start, report.find(to, start) - start);
        };
        return between("\"length\"", ",") + between("\"knots\"", "crossings");
    };
    for (const Rule rule : {Rule::mirror, Rule::natural, Rule::catmullRom})
        for (const int degree : {2, 3, 4, 5}) {
            SplineCurve near = test::curveThrough(rule, {{0, 0}, {1, 3}, {1.5, 2.75}, {4, 0}, {7, 2}});
            near.degree = degree;
            near.knots[2] = test::heldKnot({1.5, 2.75}, SplineKnot::Join::smooth, Point{1.25, 3.125}, Point{2, 2});
            SplineCurve far = near;
            for (SplineKnot& knot : far.knots)
                for (Point* const p : {&knot.at, knot.in ? &*knot.in : nullptr, knot.out ? &*knot.out : nullptr})
                    if (p)
                        *p = *p + Vector{0x1p+29, -0x1p+29};
            EXPECT_EQ(measures(reportOf(far)), measures(reportOf(near))) << degree;
        }
}

TEST(SplineReport, measuresStoredHandlesAsTheyAre) {
    // A cusp but for the last places of its middle points; relative to the first knot these would be rounded.
    SplineCurve cubic = test::curveThrough(Rule::mirror, {{0.1, 0.7}, {1.1, 0.7}});
    const Points points{{0.1, 0.7}, {1.1000001, 1.7}, {0.1, 1.7}, {1.1, 0.7}};
    cubic.knots[0] = test::heldKnot(points[0], SplineKnot::Join::corner, {}, points[1]);
    cubic.knots[1] = test::heldKnot(points[3], SplineKnot::Join::corner, points[2], {});
    for (const int degree : {3, 4, 5}) {
        cubic.degree = degree;
        EXPECT_EQ(shapesOf(cubic), (std::vector<Points>{points})) << degree;
    }
}

TEST(SplineReport, saysNothingOfACurveStillBeingDrawn) {
    const std::string report = reportOf(test::curveThrough(Rule::natural, {{0, 0}, {3, 3}}, true));
    EXPECT_THAT(report, HasSubstr(R"("incomplete": true)"));
    EXPECT_EQ(report.find("segments"), std::string::npos);
}

TEST(SplineReport, refusesMoreSegmentsThanItCanCross) {
    Document document;
    auto& curves = document.sheets[*sheetNamed("spline")].curves;
    const auto most = static_cast<std::size_t>(limits::kReportedSegments);
    curves = test::curves({test::curveThrough(Rule::mirror, Points(most, {1, 1}), true)});
    EXPECT_FALSE(reportLimitError(document));
    curves.emplace_back(test::curveThrough(Rule::mirror, {{0, 0}}));
    EXPECT_FALSE(reportLimitError(document));
    curves.emplace_back(test::curveThrough(Rule::mirror, {{0, 0}, {1, 1}}));
    ASSERT_TRUE(reportLimitError(document));
    EXPECT_EQ(reportLimitError(document)->problem, FileProblem::tooManySegments);
    EXPECT_EQ(reportLimitError(document)->place, "sheets.spline.curves");
    EXPECT_EQ(reportLimitError(document)->numbers, (std::vector<double>{20'000, 20'001}));
}

TEST(SplineResults, addUpToTheWholeLength) {
    double sum = 0;
    double whole = 0;
    const Curve closed(test::curveThrough(Rule::catmullRom, {{0, 0}, {3, 3}, {6, 0}, {7, 7}}, true));
    for (const Result& row : results(closed)) {
        if (row.caption == Caption::segmentLength)
            sum += std::get<double>(*row.value);
        if (row.caption == Caption::length)
            whole = std::get<double>(*row.value);
    }
    EXPECT_NEAR(sum, whole, 1e-13 * whole);
    EXPECT_GT(whole, 20);
}

RC_GTEST_PROP(PowerCoefficients, areThoseOfTheSameCurve, ()) {
    const Points segment = *test::anyCurve(2, 5);
    const double t = *test::anyParameter();
    const std::vector<Vector> b = powerCoefficients(segment);
    Point value{};
    for (std::size_t k = b.size(); k-- > 0;)
        value = {value.x * t + b[k].x, value.y * t + b[k].y};
    RC_ASSERT(b.size() == segment.size());
    RC_ASSERT(distance(value, evaluate(segment, t)) <= 1e-10);
}

} // namespace
} // namespace kriva
