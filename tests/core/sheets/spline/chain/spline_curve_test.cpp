#include "core/geometry/box.h"
#include "core/sheets/spline/chain/spline_curve.h"
#include "tests/core/sheets/spline/spline_values.h"

namespace kriva {
namespace {

using test::anySpline;
using test::curveThrough;
using test::farthest;
using test::heldKnot;
using Join = SplineKnot::Join;
using Rule = SplineCurve::Rule;

/// Relative to coordinates of a few units: a handful of roundings.
constexpr double kSolverRounding = 1e-14;

RC_GTEST_PROP(Spline, everySegmentRunsFromKnotToKnot, ()) {
    const SplineCurve curve = anySpline();
    const SplineChain chain = solveSpline(curve);
    RC_ASSERT(chain.segments.size() == segmentCount(curve));
    RC_ASSERT(chain.continuity.size() == curve.knots.size());
    for (std::size_t i = 0; i < chain.segments.size(); ++i) {
        RC_ASSERT(chain.segments[i].size() == static_cast<std::size_t>(curve.degree) + 1);
        RC_ASSERT(chain.segments[i].front() == curve.knots[i].at);
        RC_ASSERT(chain.segments[i].back() == curve.knots[(i + 1) % curve.knots.size()].at);
        RC_ASSERT(std::ranges::all_of(chain.segments[i], isFinite));
    }
}

RC_GTEST_PROP(Spline, itsPathIsTheChainOfItsSegmentsBitForBit, ()) {
    const SplineCurve curve = anySpline();
    RC_ASSERT(pathOf(curve) == chain(solveSpline(curve).segments, curve.closed));
    RC_ASSERT(segmentsOf(curve) == solveSpline(curve).segments);
}

RC_GTEST_PROP(Spline, storedHandlesAndInnerPointsStandBitForBit, ()) {
    const SplineCurve curve = anySpline();
    const SplineChain chain = solveSpline(curve);
    for (std::size_t i = 0; i < chain.segments.size(); ++i) {
        const SplineKnot& to = curve.knots[(i + 1) % curve.knots.size()];
        if (curve.degree == 3 && curve.knots[i].join != Join::automatic)
            RC_ASSERT(chain.segments[i][1] == *curve.knots[i].out);
        if (curve.degree == 3 && to.join != Join::automatic)
            RC_ASSERT(chain.segments[i][2] == *to.in);
        const auto inner = curve.inner.find(static_cast<int>(i));
        if (inner != curve.inner.end())
            RC_ASSERT(std::equal(inner->second.begin(), inner->second.end(), chain.segments[i].begin() + 2));
    }
}

SplineCurve shifted(SplineCurve curve, Vector by) {
    const auto shift = [by](std::optional<Point>& p) {
        if (p)
            *p = *p + by;
    };
    for (SplineKnot& knot : curve.knots) {
        knot.at = knot.at + by;
        shift(knot.in);
        shift(knot.out);
    }
    for (auto& [segment, points] : curve.inner)
        for (Point& p : points)
            p = p + by;
    return curve;
}

RC_GTEST_PROP(Spline, farFromTheOriginOnlyTheCoordinatesAreRounded, ()) {
    const SplineCurve curve = anySpline();
    const Vector offset = {1e6, -1e6};
    const SplineChain near = solveSpline(curve);
    SplineChain far = solveSpline(shifted(curve, offset));
    RC_ASSERT(far.continuity == near.continuity);
    Box box;
    for (Points& segment : far.segments)
        for (Point& p : segment)
            p = p - offset;
    for (const Points& segment : near.segments)
        box = united(box, boxOf(segment));
    const double ulp = std::nextafter(1e6, 2e6) - 1e6;
    RC_ASSERT(farthest(near.segments, far.segments) <= 1e-12 * diagonal(box) + ulp);
}

RC_GTEST_PROP(Spline, aHigherDegreeIsTheSameCurveAsTheCubic, ()) {
    SplineCurve curve = anySpline();
    curve.inner.clear();
    curve.degree = 3;
    const std::vector<Points> cubics = solveSpline(curve).segments;
    for (const int degree : {4, 5}) {
        curve.degree = degree;
        const std::vector<Points> raised = solveSpline(curve).segments;
        for (std::size_t i = 0; i < cubics.size(); ++i) {
            // The first and last derivatives tell the cubic's handles again.
            const Vector out = degree * (raised[i][1] - raised[i][0]) - 3 * (cubics[i][1] - cubics[i][0]);
            const auto n = static_cast<std::size_t>(degree);
            const Vector in = degree * (raised[i][n] - raised[i][n - 1]) - 3 * (cubics[i][3] - cubics[i][2]);
            RC_ASSERT(length(out) + length(in) <= 1e-10);
        }
    }
}

TEST(Spline, anIncompleteCurveHasNoSegments) {
    EXPECT_EQ(solveSpline({}), SplineChain());
    EXPECT_EQ(solveSpline(curveThrough(Rule::natural, {{1, 2}})), SplineChain());
    EXPECT_EQ(solveSpline(curveThrough(Rule::natural, {{1, 2}, {3, 4}}, true)), SplineChain());
    EXPECT_TRUE(isIncomplete(curveThrough(Rule::mirror, {{1, 2}, {3, 4}}, true)));
    EXPECT_FALSE(isIncomplete(curveThrough(Rule::mirror, {{1, 2}, {3, 4}})));
}

// The handles follow from P1 = 2 K - P2 and P2 = (K + P1) / 2 of the C1 chain.
TEST(Spline, threeKnotsGrowByMirroring) {
    const SplineChain chain = solveSpline(curveThrough(Rule::mirror, {{0, 0}, {3, 3}, {6, 0}}));
    const std::vector<Points> expected = {{{0, 0}, {1, 1}, {2, 2}, {3, 3}}, {{3, 3}, {4, 4}, {5, 2}, {6, 0}}};
    EXPECT_LE(farthest(chain.segments, expected), kSolverRounding);
    EXPECT_EQ(chain.continuity, (std::vector{Continuity::end, Continuity::c1, Continuity::end}));
}

TEST(Spline, threeKnotsUnderTheNaturalRule) {
    const SplineChain chain = solveSpline(curveThrough(Rule::natural, {{0, 0}, {3, 3}, {6, 0}}));
    const std::vector<Points> expected = {{{0, 0}, {1, 1.5}, {2, 3}, {3, 3}}, {{3, 3}, {4, 3}, {5, 1.5}, {6, 0}}};
    EXPECT_LE(farthest(chain.segments, expected), kSolverRounding);
    EXPECT_EQ(chain.continuity, (std::vector{Continuity::end, Continuity::c2, Continuity::end}));
}

TEST(Spline, aClampedSegmentHasTheGivenDerivatives) {
    SplineCurve arch = curveThrough(Rule::clamped, {{0, 0}, {3, 0}});
    arch.startDerivative = Vector{0, 3};
    arch.endDerivative = Vector{0, -3};
    EXPECT_EQ(solveSpline(arch).segments, (std::vector<Points>{{{0, 0}, {0, 1}, {3, 1}, {3, 0}}}));
}

TEST(Spline, aClosedSquareIsRound) {
    const Points square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    const SplineChain periodic = solveSpline(curveThrough(Rule::natural, square, true));
    EXPECT_LE(farthest({periodic.segments[0]}, {{{0, 0}, {0.5, -0.5}, {1.5, -0.5}, {2, 0}}}), kSolverRounding);
    EXPECT_LE(farthest({periodic.segments[3]}, {{{0, 2}, {-0.5, 1.5}, {-0.5, 0.5}, {0, 0}}}), kSolverRounding);
    EXPECT_EQ(periodic.continuity, std::vector(4, Continuity::c2));

    const SplineChain local = solveSpline(curveThrough(Rule::catmullRom, square, true));
    const double third = 1.0 / 3;
    EXPECT_LE(farthest({local.segments[1]}, {{{2, 0}, {2 + third, third}, {2 + third, 2 - third}, {2, 2}}}),
              kSolverRounding);
    EXPECT_EQ(local.continuity, std::vector(4, Continuity::g2));
}

TEST(Spline, parabolasThroughPointsOfAParabolaAreThatParabola) {
    const Points onParabola = {{0, 0}, {2, 3}, {4, 4}, {6, 3}, {8, 0}};
    const SplineChain chain = solveSpline(curveThrough(Rule::mirror, onParabola, false, 2));
    const std::vector<Points> expected = {
        {{0, 0}, {1, 2}, {2, 3}}, {{2, 3}, {3, 4}, {4, 4}}, {{4, 4}, {5, 4}, {6, 3}}, {{6, 3}, {7, 2}, {8, 0}}};
    EXPECT_LE(farthest(chain.segments, expected), kSolverRounding);
    EXPECT_EQ(chain.continuity[2], Continuity::c2);
}

TEST(Spline, degreeFourTakesStoredHandlesAndReplacedInnerPoints) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 2}, {5, 0}}, false, 4);
    curve.knots[1] = heldKnot({3, 2}, Join::symmetric, Point{2, 2}, Point{4, 2});
    curve.inner[1] = {{4.5, 1}};
    const SplineChain chain = solveSpline(curve);
    const std::vector<Points> expected = {{{0, 0}, {0.75, 0.5}, {1.5, 4.0 / 3}, {2.25, 2}, {3, 2}},
                                          {{3, 2}, {3.75, 2}, {4.5, 1}, {4.625, 0.75}, {5, 0}}};
    EXPECT_LE(farthest(chain.segments, expected), kSolverRounding);
    EXPECT_EQ(chain.continuity[1], Continuity::c1);
}

TEST(Spline, lowDegreesIgnoreInnerPoints) {
    for (const int degree : {2, 3}) {
        SplineCurve curve = curveThrough(Rule::natural, {{0, 0}, {3, 2}, {5, 0}}, false, degree);
        const SplineChain without = solveSpline(curve);
        curve.inner[0] = {{7, 7}};
        EXPECT_EQ(solveSpline(curve), without);
    }
}

TEST(Spline, degreeTwoIgnoresRuleAndHandles) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 2}, {5, 0}, {4, -3}}, false, 2);
    const SplineChain plain = solveSpline(curve);
    curve.rule = Rule::clamped;
    curve.startDerivative = Vector{9, 9};
    curve.knots[1] = heldKnot({3, 2}, Join::corner, Point{2, 2}, Point{4, 2});
    EXPECT_EQ(solveSpline(curve), plain);
}

TEST(Spline, knotsInOnePlaceGiveSegmentsOfOnePoint) {
    for (const Rule rule : {Rule::mirror, Rule::natural, Rule::clamped, Rule::catmullRom})
        for (const bool closed : {false, true})
            for (const int degree : {2, 3, 4, 5}) {
                const SplineChain chain = solveSpline(curveThrough(rule, {{1, 2}, {1, 2}, {1, 2}}, closed, degree));
                for (const Points& segment : chain.segments)
                    EXPECT_EQ(segment, Points(static_cast<std::size_t>(degree) + 1, {1, 2}));
            }
}

} // namespace
} // namespace kriva
