#include "core/bezier/elevate.h"
#include "core/bezier/evaluate.h"
#include "core/bezier/subdivide.h"
#include "core/intersections/crossings.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <gmock/gmock.h>

namespace kriva {
namespace {

using Chain = std::vector<Points>;

Crossings crossingsOf(const std::vector<Chain>& chains, bool closed = false) {
    std::vector<SegmentChain> parts;
    for (const Chain& chain : chains)
        parts.push_back({chain, closed});
    return findCrossings(parts);
}

Points line(Point from, Point to) {
    return {from, lerp(from, to, 1.0 / 3), lerp(from, to, 2.0 / 3), to};
}

MATCHER_P3(isPass, curve, segment, t, "") {
    return arg.curve == std::size_t(curve) && arg.segment == std::size_t(segment) && std::abs(arg.t - t) <= 1e-7;
}

/// Passes that touch are told less exactly.
MATCHER_P3(isTouch, curve, segment, t, "") {
    return arg.curve == std::size_t(curve) && arg.segment == std::size_t(segment) && std::abs(arg.t - t) <= 1e-6;
}

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const Points kArch{{0, 0}, {0, 4}, {4, 4}, {4, 0}}; // its top, (2, 3), is at t = 1/2

TEST(Crossings, linesCrossOnce) {
    const Crossings found = crossingsOf({{line({0, 0}, {4, 4})}, {line({0, 4}, {4, 0})}, {line({5, 0}, {5, 4})}});
    ASSERT_THAT(found.places, SizeIs(1));
    EXPECT_THAT(found.places[0].passes, ElementsAre(isPass(0, 0, 0.5), isPass(1, 0, 0.5)));
    EXPECT_NEAR(found.places[0].at.x, 2, 1e-12);
    EXPECT_THAT(found.overlaps, IsEmpty());
}

TEST(Crossings, aTopThatTouchesALineIsOnePlace) {
    for (const double y : {3.0, 3 + 1e-13, 3 - 1e-13}) {
        const Crossings found = crossingsOf({{kArch}, {line({-1, y}, {7, y})}});
        ASSERT_THAT(found.places, SizeIs(1)) << y;
        EXPECT_THAT(found.places[0].passes, ElementsAre(isTouch(0, 0, 0.5), isTouch(1, 0, 0.375)));
    }
}

TEST(Crossings, aTopJustBelowALineDoesNotTouch) {
    EXPECT_THAT(crossingsOf({{kArch}, {line({-1, 3 + 1e-10}, {7, 3 + 1e-10})}}).places, IsEmpty());
}

TEST(Crossings, aTopJustAboveALineIsCrossedTwice) {
    // y = 3 - 12 (t - 1/2)^2
    for (const double depth : {1e-3, 1e-6, 1e-9, 1e-10}) {
        const Crossings found = crossingsOf({{kArch}, {line({-1, 3 - depth}, {7, 3 - depth})}});
        ASSERT_THAT(found.places, SizeIs(2)) << depth;
        const double away = std::sqrt(depth / 12);
        EXPECT_NEAR(found.places[0].passes[0].t, 0.5 - away, 1e-7);
        EXPECT_NEAR(found.places[1].passes[0].t, 0.5 + away, 1e-7);
    }
}

TEST(Crossings, twoCurvesThatTouchAreOnePlace) {
    // Two arches back to back, the upper one flatter.
    const Points below{{0, 0}, {0, 4}, {4, 4}, {4, 0}};
    const Points above{{-1, 5}, {1, 2.333333333333333333}, {3, 2.333333333333333333}, {5, 5}};
    const Crossings found = crossingsOf({{below}, {above}});
    ASSERT_THAT(found.places, SizeIs(1));
    EXPECT_THAT(found.places[0].passes, ElementsAre(isTouch(0, 0, 0.5), isTouch(1, 0, 0.5)));
}

TEST(Crossings, anInflectionTangentCrossesOnce) {
    // y = (2t - 1)^3, x = 2t - 1: three equal roots.
    const Points wave{{-1, -1}, {-1.0 / 3, 1}, {1.0 / 3, -1}, {1, 1}};
    for (const double from : {-2.0, -1.37, -3.1}) {
        const Crossings found = crossingsOf({{wave}, {line({from, 0}, {2, 0})}});
        ASSERT_THAT(found.places, SizeIs(1));
        EXPECT_THAT(found.places[0].passes, ElementsAre(isTouch(0, 0, 0.5), isTouch(1, 0, from / (from - 2))));
    }
}

TEST(Crossings, aCurveFlatToFourthOrderTouchesOnce) {
    // y = x^4 for x = 2t - 1.
    const Points bowl{{-1, 1}, {-0.5, -1}, {0, 1}, {0.5, -1}, {1, 1}};
    const Points floor = elevated(line({-1.3, 0}, {2, 0}), 1);
    const Crossings found = crossingsOf({{bowl}, {floor}});
    ASSERT_THAT(found.places, SizeIs(1));
    EXPECT_THAT(found.places[0].passes, ElementsAre(isTouch(0, 0, 0.5), isTouch(1, 0, 1.3 / 3.3)));
}

TEST(Crossings, curvesThatRunBesideEachOtherDoNotCross) {
    const Points flat{{0, 0}, {1, 1}, {3, 1}, {4, 0}};
    for (const double gap : {1e-3, 1e-6, 1e-8, 1e-10}) {
        Points beside = flat;
        for (Point& p : beside)
            p.y += gap;
        EXPECT_THAT(crossingsOf({{flat}, {beside}}).places, IsEmpty()) << gap;
    }
}

TEST(Crossings, anEndOnAnotherCurveCounts) {
    const Crossings found = crossingsOf({{kArch}, {line({2, 3}, {2, 9})}});
    ASSERT_THAT(found.places, SizeIs(1));
    EXPECT_THAT(found.places[0].passes, ElementsAre(isPass(0, 0, 0.5), isPass(1, 0, 0)));
    EXPECT_THAT(crossingsOf({{kArch}, {line({2, 3 + 1e-10}, {2, 9})}}).places, IsEmpty());
}

TEST(Crossings, aLoopIsCountedHoweverSmall) {
    // A cusp at t = 1/2 opened to a loop by moving the inner control points apart.
    for (const double by : {1.0, 1e-2, 1e-4, 1e-6}) {
        const Points curve{{0, 0}, {1 + by, 1}, {0 - by, 1}, {1, 0}};
        const Crossings found = crossingsOf({{curve}});
        ASSERT_THAT(found.places, SizeIs(1)) << by;
        const double h = std::sqrt(0.75 * by / (2 + 3 * by) / 1.0);
        EXPECT_NEAR(found.places[0].passes[0].t + found.places[0].passes[1].t, 1, 1e-9);
        EXPECT_LT(distance(evaluate(curve, found.places[0].passes[0].t), evaluate(curve, found.places[0].passes[1].t)),
                  1e-12)
            << h;
    }
}

TEST(Crossings, aCurveThatTouchesItselfIsOnePlace) {
    const Points curve{{0, 3}, {3, 0}, {1, 3}, {0, 2}, {3, 1}};
    const Crossings found = crossingsOf({{curve}});
    ASSERT_THAT(found.places, SizeIs(2));
    const double h = std::sqrt(1.0 / 12);
    EXPECT_THAT(found.places[1].passes, ElementsAre(isTouch(0, 0, 0.5 - h), isTouch(0, 0, 0.5 + h)));
}

TEST(Crossings, aCuspIsNone) {
    EXPECT_THAT(crossingsOf({{{{0, 0}, {1, 1}, {0, 1}, {1, 0}}}}).places, IsEmpty());
    EXPECT_THAT(crossingsOf({{elevated(Points{{0, 0}, {1, 1}, {0, 1}, {1, 0}}, 2)}}).places, IsEmpty());
    EXPECT_THAT(crossingsOf({{{{1e6, 0}, {1e6 + 1, 1}, {1e6, 1}, {1e6 + 1, 0}}}}).places, IsEmpty());
}

TEST(Crossings, aLineThroughACuspIsOnePlace) {
    // The cusp is at (1/2, 3/4), its tangent upright.
    for (const Vector way : {Vector{1, 0.25}, Vector{1, 0}, Vector{0, 1}}) {
        const Point cusp{0.5, 0.75};
        const Crossings found = crossingsOf({{{{0, 0}, {1, 1}, {0, 1}, {1, 0}}}, {line(cusp - way, cusp + way)}});
        ASSERT_THAT(found.places, SizeIs(testing::Ge(1U))) << way.x << ' ' << way.y;
        const auto isHere = [&](const Crossing& place) { return distance(place.at, cusp) <= 1e-9; };
        ASSERT_EQ(std::ranges::count_if(found.places, isHere), 1);
        EXPECT_THAT(std::ranges::find_if(found.places, isHere)->passes,
                    ElementsAre(isTouch(0, 0, 0.5), isTouch(1, 0, 0.5)));
    }
}

TEST(Crossings, threeCurvesThroughOnePlaceAreOneEntry) {
    const Crossings found = crossingsOf(
        {{line({-1, -1}, {1, 1})}, {line({-1, 1}, {1, -1})}, {line({-1, 0}, {2, 0})}, {line({0, 3}, {0, -2})}});
    ASSERT_THAT(found.places, SizeIs(1));
    EXPECT_THAT(found.places[0].passes,
                ElementsAre(isPass(0, 0, 0.5), isPass(1, 0, 0.5), isPass(2, 0, 1.0 / 3), isPass(3, 0, 0.6)));
}

TEST(Crossings, aKnotIsNoneUnlessAnotherPassGoesThroughIt) {
    const Chain corner{line({-2, 0}, {0, 1}), line({0, 1}, {2, 0})};
    EXPECT_THAT(crossingsOf({corner}).places, IsEmpty());
    const Crossings found = crossingsOf({corner, {line({0, -3}, {0, 3})}});
    ASSERT_THAT(found.places, SizeIs(1));
    EXPECT_THAT(found.places[0].passes, ElementsAre(isPass(0, 1, 0), isPass(1, 0, 2.0 / 3)));
}

TEST(Crossings, twoKnotsInOnePlaceAreOne) {
    const Chain eight{line({0, 0}, {1, 1}), line({1, 1}, {2, 0}), line({2, 0}, {1, 1}), line({1, 1}, {0, 2})};
    const Chain bow{line({0, 0}, {2, 2}), line({2, 2}, {2, 0}), line({2, 0}, {0, 2}), line({0, 2}, {0, 0})};
    EXPECT_THAT(crossingsOf({eight}).overlaps, SizeIs(1));
    const Crossings found = crossingsOf({bow}, true);
    ASSERT_THAT(found.places, SizeIs(1));
    EXPECT_THAT(found.places[0].passes, ElementsAre(isPass(0, 0, 0.5), isPass(0, 2, 0.5)));
    // The same bow, not closed: its ends meet.
    EXPECT_THAT(crossingsOf({bow}).places, SizeIs(2));
}

TEST(Crossings, segmentsOfOnePointTakeNoPart) {
    const Points point(4, Point{0, 1});
    const Chain chain{line({-2, 0}, {0, 1}), point, point, line({0, 1}, {2, 0})};
    EXPECT_THAT(crossingsOf({chain}).places, IsEmpty());
    const Crossings found = crossingsOf({chain, {line({0, -3}, {0, 3})}});
    ASSERT_THAT(found.places, SizeIs(1));
    EXPECT_THAT(found.places[0].passes, ElementsAre(isPass(0, 3, 0), isPass(1, 0, 2.0 / 3)));
}

TEST(Crossings, straightSegmentsThatTurnBackAreLeftOut) {
    const Points turning{{0, 0}, {4, 0}, {-1, 0}, {3, 0}};
    const Crossings found = crossingsOf({{turning}, {line({1, -1}, {1, 1})}, {line({0, 0}, {3, 0})}});
    ASSERT_THAT(found.places, SizeIs(1));
    EXPECT_THAT(found.places[0].passes, ElementsAre(isPass(1, 0, 0.5), isPass(2, 0, 1.0 / 3)));
    EXPECT_THAT(found.overlaps, IsEmpty());
}

MATCHER_P4(isPart, curve, segment, from, to, "") {
    return arg.curve == std::size_t(curve) && arg.segment == std::size_t(segment) &&
           std::abs(arg.from - from) <= 1e-7 && std::abs(arg.to - to) <= 1e-7;
}

TEST(Overlaps, partsOfOneCurveLieOnEachOther) {
    const Points first = part(kArch, 0, 0.75), second = part(kArch, 0.25, 1);
    const Points back(second.rbegin(), second.rend());
    const Crossings found = crossingsOf({{first}, {second}});
    EXPECT_THAT(found.places, IsEmpty());
    ASSERT_THAT(found.overlaps, SizeIs(1));
    EXPECT_THAT(found.overlaps[0].passes, ElementsAre(isPart(0, 0, 1.0 / 3, 1), isPart(1, 0, 0, 2.0 / 3)));
    const Crossings turned = crossingsOf({{first}, {back}});
    EXPECT_THAT(turned.places, IsEmpty());
    ASSERT_THAT(turned.overlaps, SizeIs(1));
    EXPECT_THAT(turned.overlaps[0].passes, ElementsAre(isPart(0, 0, 1.0 / 3, 1), isPart(1, 0, 1, 1.0 / 3)));
}

TEST(Overlaps, theSameCurveTwiceIsOne) {
    for (const Points& curve : {kArch, line({0, 0}, {3, 1}), Points{{0, 0}, {6, 4}, {-2, 4}, {4, 0}}}) {
        const Crossings found = crossingsOf({{curve}, {curve}});
        ASSERT_THAT(found.overlaps, SizeIs(1));
        EXPECT_THAT(found.overlaps[0].passes, ElementsAre(isPart(0, 0, 0, 1), isPart(1, 0, 0, 1)));
        EXPECT_LE(found.places.size(), 1U); // the loop's own crossing, with four passes
        for (const Crossing& place : found.places)
            EXPECT_THAT(place.passes, SizeIs(4));
    }
}

TEST(Overlaps, collinearLinesShareWhatIsCommon) {
    // The second is drawn at another speed.
    const Crossings found = crossingsOf({{line({0, 0}, {4, 2})}, {{{2, 1}, {2, 1}, {6, 3}, {6, 3}}}});
    EXPECT_THAT(found.places, IsEmpty());
    ASSERT_THAT(found.overlaps, SizeIs(1));
    EXPECT_THAT(found.overlaps[0].passes, ElementsAre(isPart(0, 0, 0.5, 1), isPart(1, 0, 0, 0.5)));
}

TEST(Overlaps, aThirdCurveThroughOneIsAPlaceWithAllPasses) {
    const Crossings found = crossingsOf({{kArch}, {kArch}, {line({2, 0}, {2, 5})}});
    ASSERT_THAT(found.overlaps, SizeIs(1));
    ASSERT_THAT(found.places, SizeIs(1));
    EXPECT_THAT(found.places[0].passes, ElementsAre(isPass(0, 0, 0.5), isPass(1, 0, 0.5), isPass(2, 0, 0.6)));
}

TEST(Overlaps, aParabolaTracedForthAndBackLiesOnItself) {
    // (q, q^2) with q = t (1 - t).
    const Points curve{{0, 0}, {0.25, 0}, {1.0 / 3, 1.0 / 6}, {0.25, 0}, {0, 0}};
    const Crossings found = crossingsOf({{curve}});
    EXPECT_THAT(found.places, IsEmpty());
    ASSERT_THAT(found.overlaps, SizeIs(1));
    EXPECT_THAT(found.overlaps[0].passes, ElementsAre(isPart(0, 0, 0, 0.5), isPart(0, 0, 1, 0.5)));
}

TEST(Overlaps, aChainThatRunsBackLiesOnItself) {
    const Points back(kArch.rbegin(), kArch.rend());
    const Crossings found = crossingsOf({{kArch, back}});
    ASSERT_THAT(found.overlaps, SizeIs(1));
    EXPECT_THAT(found.overlaps[0].passes, ElementsAre(isPart(0, 0, 0, 1), isPart(0, 1, 1, 0)));
    EXPECT_THAT(found.places, IsEmpty());
}

Chain anyChain(int degree) {
    Chain chain;
    const int count = *rc::gen::inRange(1, 5);
    Point start = *test::anyPoint();
    for (int i = 0; i < count; ++i) {
        Points segment = *test::anyCurve(degree, degree);
        segment.front() = start;
        start = segment.back();
        chain.push_back(segment);
    }
    return chain;
}

RC_GTEST_PROP(Crossings, everyPassIsAtThePlace, ()) {
    const int degree = *rc::gen::inRange(2, 6);
    const std::vector<Chain> chains{anyChain(degree), anyChain(degree)};
    for (const Crossing& place : crossingsOf(chains).places) {
        RC_ASSERT(place.passes.size() >= 2);
        for (const Pass& pass : place.passes)
            RC_ASSERT(distance(evaluate(chains[pass.curve][pass.segment], pass.t), place.at) <= 1e-6);
    }
}

RC_GTEST_PROP(Crossings, areTheSameOfCurvesCutInPieces, ()) {
    const int degree = *rc::gen::inRange(2, 6);
    const std::vector<Chain> chains{anyChain(degree), anyChain(degree)};
    const double t = *rc::gen::elementOf(std::vector{0.4375, 0.5, 0.59375});
    std::vector<Chain> cut(2);
    for (std::size_t i = 0; i < 2; ++i)
        for (const Points& segment : chains[i]) {
            const auto [left, right] = split(segment, t);
            cut[i].push_back(left);
            cut[i].push_back(right);
        }
    const Crossings whole = crossingsOf(chains), pieces = crossingsOf(cut);
    RC_ASSERT(whole.places.size() == pieces.places.size());
    for (std::size_t i = 0; i < whole.places.size(); ++i)
        RC_ASSERT(distance(whole.places[i].at, pieces.places[i].at) <= 1e-6);
}

RC_GTEST_PROP(Crossings, areTheSameOfElevatedCurves, ()) {
    const std::vector<Chain> chains{anyChain(3), anyChain(3)};
    std::vector<Chain> raised(2);
    for (std::size_t i = 0; i < 2; ++i)
        for (const Points& segment : chains[i])
            raised[i].push_back(elevated(segment, *rc::gen::inRange(0, 3)));
    RC_ASSERT(crossingsOf(chains).places.size() == crossingsOf(raised).places.size());
}

RC_GTEST_PROP(Crossings, doNotDependOnTheDirection, ()) {
    const int degree = *rc::gen::inRange(2, 6);
    const Chain one = anyChain(degree), other = anyChain(degree);
    Chain turned;
    for (auto segment = one.rbegin(); segment != one.rend(); ++segment)
        turned.emplace_back(segment->rbegin(), segment->rend());
    RC_ASSERT(crossingsOf({one, other}).places.size() == crossingsOf({other, turned}).places.size());
}

TEST(Overlaps, areToldOnceWhereTheSpeedIsZeroAtTheirEnds) {
    const Points standing{{0, 0}, {0, 0}, {1, 0}, {1, 0}};
    const Points shifted{{0, 1e-14}, {0, 0}, {1, 0}, {1, -1e-14}};
    for (const Points& other : {standing, shifted, line({0, 0}, {1, 0}), elevated(standing, 2)}) {
        const Crossings found = crossingsOf({{standing}, {other}});
        EXPECT_THAT(found.places, IsEmpty());
        ASSERT_THAT(found.overlaps, SizeIs(1));
        const auto& [one, second] = found.overlaps[0].passes;
        EXPECT_EQ(one.from, 0);
        EXPECT_EQ(one.to, 1);
        EXPECT_EQ(second.from, 0);
        EXPECT_EQ(second.to, 1);
    }
}

TEST(Overlaps, areToldOnceAcrossACusp) {
    const Points cusp{{0, 0}, {1, 1}, {0, 1}, {1, 0}};
    Points rounded = cusp;
    for (Point& p : rounded)
        p = {p.x * (1 + 1e-15), p.y * (1 - 1e-15)};
    for (const Points& other : {cusp, rounded, elevated(cusp, 1)}) {
        const Crossings found = crossingsOf({{cusp}, {other}});
        EXPECT_THAT(found.places, IsEmpty());
        ASSERT_THAT(found.overlaps, SizeIs(1));
        EXPECT_EQ(found.overlaps[0].passes[0].from, 0);
        EXPECT_EQ(found.overlaps[0].passes[0].to, 1);
    }
}

TEST(Loops, thatEndWhereTheyBeganAlongOneLineAreOnePlace) {
    const std::vector<Points> rings{{{0, 0}, {4, 0}, {0, 3}, {8, 0}, {0, 0}},
                                    {{0, 0}, {4, 0}, {0, 3}, {-8, 0}, {0, 0}},
                                    {{0, 0}, {4, 0}, {0, 3}, {5, 4}, {8, 0}, {0, 0}},
                                    {{0.04059855762974366, 0.018755189105535097},
                                     {0.027683340970230473, 0.03249392027669455},
                                     {0.02029927881487183, 0.009377594552767548},
                                     {0.03414094929998707, 0.025624554691114826},
                                     {0.04059855762974366, 0.018755189105535097}}};
    for (const Points& ring : rings) {
        const Crossings open = crossingsOf({{ring}});
        const auto isAtKnot = [&](const Crossing& place) { return distance(place.at, ring.front()) < 1e-6; };
        EXPECT_EQ(std::ranges::count_if(open.places, isAtKnot), 1);
        const Crossings closed = crossingsOf({{ring}}, true);
        EXPECT_EQ(std::ranges::count_if(closed.places, isAtKnot), 0) << "its own knot is no crossing";
    }
}

} // namespace
} // namespace kriva
