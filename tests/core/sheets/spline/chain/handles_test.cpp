#include "core/sheets/spline/chain/handles.h"
#include "tests/core/sheets/spline/spline_values.h"

namespace kriva {
namespace {

using test::anySpline;
using test::curveThrough;
using test::farthest;
using test::heldKnot;
using Join = SplineKnot::Join;
using Rule = SplineCurve::Rule;

double biggest(const std::vector<Points>& cubics) {
    double most = 0;
    for (const Points& cubic : cubics)
        for (const Point p : cubic)
            most = std::max({most, std::abs(p.x), std::abs(p.y)});
    return most;
}

/// A cubic curve of a rule; stored handles and derivatives as they come.
SplineCurve anyCubic(Rule rule, bool closed) {
    SplineCurve curve = anySpline();
    curve.degree = 3;
    curve.rule = rule;
    curve.closed = closed;
    return curve;
}

RC_GTEST_PROP(MirrorHandles, continueStraightAndEndWithoutBending, (bool closed)) {
    const SplineCurve curve = anyCubic(Rule::mirror, closed);
    const std::vector<Points> cubics = solveSpline(curve).segments;
    const double rounding = 1e-14 * biggest(cubics);
    for (std::size_t i = 0; i < cubics.size(); ++i) {
        const std::size_t next = (i + 1) % curve.knots.size();
        if (curve.knots[next].join != Join::automatic)
            continue;
        if (next > 0) // a closed chain's very last handle follows the first one instead
            RC_ASSERT(distance(cubics[i][2], midpoint(curve.knots[next].at, cubics[i][1])) <= rounding);
        if (next < cubics.size())
            RC_ASSERT(distance(cubics[next][1], mirrored(cubics[i][2], curve.knots[next].at)) <= rounding);
    }
}

TEST(MirrorHandles, goOnFromStoredHandles) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {4, 0}, {8, 0}, {12, 0}});
    curve.knots[1] = heldKnot({4, 0}, Join::corner, Point{3, 1}, Point{5, 2});
    const std::vector<Points> expected = {{{0, 0}, {4.0 / 3, 0}, {3, 1}, {4, 0}},
                                          {{4, 0}, {5, 2}, {6.5, 1}, {8, 0}},
                                          {{8, 0}, {9.5, -1}, {10.75, -0.5}, {12, 0}}};
    EXPECT_LE(farthest(solveSpline(curve).segments, expected), 1e-14);
}

TEST(MirrorHandles, closeWithTheMirrorImageOfTheFirst) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 0}, {3, 3}}, true);
    EXPECT_EQ(solveSpline(curve).segments.back()[2], (Point{-1, 0}));
    EXPECT_EQ(solveSpline(curve).continuity, std::vector(3, Continuity::c1));
    curve.knots[0] = heldKnot({0, 0}, Join::corner, Point{0, 2}, Point{1, 1});
    EXPECT_EQ(solveSpline(curve).segments.back()[2], (Point{0, 2}));
    EXPECT_EQ(solveSpline(curve).segments.front()[2], (Point{2, 0.5}));
}

RC_GTEST_PROP(C2Handles, bendSteadilyThroughAutomaticKnots, (bool closed, bool isClamped)) {
    const SplineCurve curve = anyCubic(isClamped ? Rule::clamped : Rule::natural, closed);
    const SplineChain chain = solveSpline(curve);
    for (std::size_t i = closed ? 0 : 1; i < chain.segments.size(); ++i) {
        if (curve.knots[i].join != Join::automatic)
            continue;
        const Points& before = chain.segments[(i + chain.segments.size() - 1) % chain.segments.size()];
        const Points& after = chain.segments[i];
        const double rounding = 1e-14 * biggest(chain.segments);
        RC_ASSERT(length((before[3] - before[2]) - (after[1] - after[0])) <= rounding);
        const Vector bendBefore = (before[3] - before[2]) - (before[2] - before[1]);
        const Vector bendAfter = (after[2] - after[1]) - (after[1] - after[0]);
        RC_ASSERT(length(bendAfter - bendBefore) <= 4 * rounding);
    }
}

RC_GTEST_PROP(C2Handles, openEndsKeepTheirOwnRule, (bool isClamped)) {
    const SplineCurve curve = anyCubic(isClamped ? Rule::clamped : Rule::natural, false);
    SplineCurve naturalCurve = curve;
    naturalCurve.rule = Rule::natural;
    const std::vector<Points> cubics = solveSpline(curve).segments;
    const std::vector<Points> natural = solveSpline(naturalCurve).segments;
    const double rounding = 1e-13 * (1 + biggest(cubics) + biggest(natural));
    const Points& first = cubics.front();
    const Points& last = cubics.back();
    if (curve.knots.front().join == Join::automatic && !isClamped)
        RC_ASSERT(length((first[2] - first[1]) - (first[1] - first[0])) <= rounding);
    if (curve.knots.front().join == Join::automatic && isClamped) {
        const Vector wanted = curve.startDerivative.value_or(3 * (natural.front()[1] - natural.front()[0]));
        RC_ASSERT(length(3 * (first[1] - first[0]) - wanted) <= rounding);
    }
    if (curve.knots.back().join == Join::automatic && isClamped) {
        const Vector wanted = curve.endDerivative.value_or(3 * (natural.back()[3] - natural.back()[2]));
        RC_ASSERT(length(3 * (last[3] - last[2]) - wanted) <= rounding);
    }
}

RC_GTEST_PROP(C2Handles, theNaturalChainReadsTheSameBackwards, (bool closed)) {
    SplineCurve curve = anyCubic(Rule::natural, closed);
    std::vector<Points> forwards = solveSpline(curve).segments;
    std::ranges::reverse(curve.knots);
    if (closed) // the first knot stays first
        std::ranges::rotate(curve.knots, curve.knots.end() - 1);
    for (SplineKnot& knot : curve.knots)
        std::swap(knot.in, knot.out);
    std::ranges::reverse(forwards);
    for (Points& cubic : forwards)
        std::ranges::reverse(cubic);
    RC_ASSERT(farthest(solveSpline(curve).segments, forwards) <= 1e-13 * biggest(forwards));
}

RC_GTEST_PROP(C2Handles, derivativesMeanNothingToClosedChainsAndOtherRules, ()) {
    SplineCurve curve = anySpline();
    if (curve.rule == Rule::clamped)
        curve.closed = true;
    const SplineChain with = solveSpline(curve);
    curve.startDerivative = Vector{77, 1};
    curve.endDerivative.reset();
    RC_ASSERT(solveSpline(curve) == with);
}

// v = (1, 0)/1 - (1, 4)/(1 + 2) + (0, 4)/2 for the steps 1 and 2, the square roots of the distances 1 and 4.
TEST(CatmullRomHandles, followTheCentripetalTangent) {
    const std::vector<Points> cubics = solveSpline(curveThrough(Rule::catmullRom, {{0, 0}, {1, 0}, {1, 4}})).segments;
    const Vector v = {2.0 / 3, 2.0 / 3};
    const std::vector<Points> expected = {{{0, 0}, {1.0 / 3, 0}, Point{1, 0} - v / 3, {1, 0}},
                                          {{1, 0}, Point{1, 0} + v * 2 / 3, {1, 4 - 4.0 / 3}, {1, 4}}};
    EXPECT_LE(farthest(cubics, expected), 1e-15);
}

TEST(CatmullRomHandles, areRetractedBesideCoincidentKnots) {
    const std::vector<Points> cubics =
        solveSpline(curveThrough(Rule::catmullRom, {{0, 0}, {2, 2}, {2, 2}, {5, 0}, {6, 1}})).segments;
    EXPECT_EQ(cubics[0][2], (Point{2, 2}));
    EXPECT_EQ(cubics[1], Points(4, {2, 2}));
    EXPECT_EQ(cubics[2][1], (Point{2, 2}));
    EXPECT_NE(cubics[2][2], (Point{5, 0}));
}

RC_GTEST_PROP(CatmullRomHandles, dependOnNeighboursOnly, ()) {
    SplineCurve curve = anyCubic(Rule::catmullRom, false);
    curve.knots.resize(3);
    curve.knots.insert(curve.knots.end(), 4, SplineKnot{{200, 1}, {}, {}, {}});
    curve.knots[4].at = {300, 7};
    const std::vector<Points> before = solveSpline(curve).segments;
    curve.knots.back().at = *test::anyPoint();
    const std::vector<Points> after = solveSpline(curve).segments;
    RC_ASSERT(std::equal(before.begin(), before.begin() + 4, after.begin()));
}

TEST(Handles, aMissingStoredHandleIsRetracted) {
    for (const Rule rule : {Rule::mirror, Rule::natural, Rule::clamped, Rule::catmullRom}) {
        SplineCurve curve = curveThrough(rule, {{0, 0}, {1, 3}, {5, 0}});
        curve.knots[1].join = Join::corner;
        const std::vector<Points> cubics = solveSpline(curve).segments;
        EXPECT_EQ(cubics[0][2], (Point{1, 3}));
        EXPECT_EQ(cubics[1][1], (Point{1, 3}));
    }
}

TEST(CatmullRomHandles, areRetractedWhereTheChainTurnsStraightBack) {
    const std::vector<Points> cubics =
        solveSpline(curveThrough(Rule::catmullRom, {{0.1, 3}, {0.7, 3}, {0.2, 3}, {1.3, 3}})).segments;
    for (const std::size_t knot : {1U, 2U}) {
        EXPECT_EQ(cubics[knot - 1][2], cubics[knot][0]);
        EXPECT_EQ(cubics[knot][1], cubics[knot][0]);
    }
}

} // namespace
} // namespace kriva
