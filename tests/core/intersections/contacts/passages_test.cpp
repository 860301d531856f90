#include "core/bezier/elevate.h"
#include "core/intersections/contacts/passages.h"
#include "tests/core/intersections/arcs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>

namespace kriva {
namespace {

using test::kArch;
using test::kTouching;
using test::plainArc;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<double> passages(const Arc& arc, Point place, double gap = kTouching) {
    WorkBudget budget;
    return passagesThrough(arc, place, gap, budget);
}

bool areTouching(const Arc& a, const Arc& b, Contact one, Contact other, double touching = kTouching) {
    WorkBudget budget;
    return touchBetween(a, b, one, other, touching, budget);
}

auto near(double t, double allowed = 1e-9) {
    return DoubleNear(t, allowed);
}

const Points kLoop{{0, 0}, {6, 4}, {-2, 4}, {4, 0}}; // meets itself at 1/2 -+ sqrt(21) / 14

TEST(Foot, isTheEndOfThePerpendicular) {
    const Arc line = plainArc(Points{{0, 0}, {4, 0}});
    EXPECT_NEAR(foot(line, {1, 0.5}, 0.5), 0.25, 1e-15);
    EXPECT_EQ(foot(line, {-1, 0.5}, 0.5), 0) << "no farther than the ends";
    EXPECT_EQ(foot(line, {5, 0.5}, 0.5), 1);
}

TEST(Foot, staysWhereTheArcStandsStill) {
    EXPECT_EQ(foot(plainArc(Points(4, Point{1, 1})), {1, 1.5}, 0.375), 0.375);
}

RC_GTEST_PROP(Foot, standsUprightOnTheArc, ()) {
    const Arc arc = *test::anyArc();
    const double t = *rc::gen::inRange(4, 13) / 16.0;
    const auto [at, velocity] = evaluate(arc, t);
    RC_PRE(length(velocity) > 0.1);
    const Point place = at + 1e-6 * Vector{-velocity.y, velocity.x};
    const double found = foot(arc, place, t + 1e-4);
    RC_ASSERT(std::abs(found - t) <= 1e-3);
    const ArcPoint there = evaluate(arc, found);
    RC_ASSERT(std::abs(dot(place - there.at, there.velocity)) <= 1e-12);
}

RC_GTEST_PROP(Passages, areFoundThroughEachPlaceOfTheArc, ()) {
    const Arc arc = *test::anyArc();
    const double t = *test::anyParameter();
    const std::vector<double> found = passages(arc, evaluate(arc, t).at);
    RC_ASSERT(std::ranges::is_sorted(found));
    for (const double passage : found)
        RC_ASSERT(distance(evaluate(arc, passage).at, evaluate(arc, t).at) <= kTouching);
    // One of them without leaving the place in between.
    RC_ASSERT(std::ranges::any_of(found, [&](double passage) {
        return passage == t || part(arc, std::min(passage, t), std::max(passage, t)).size() <= 1e-9;
    }));
}

TEST(Passages, areToldOnceForEachPass) {
    const double h = std::sqrt(21.0) / 14;
    const Arc loop = plainArc(kLoop);
    EXPECT_THAT(passages(loop, evaluate(loop, 0.5 - h).at), ElementsAre(near(0.5 - h), near(0.5 + h)));
    EXPECT_THAT(passages(loop, evaluate(loop, 0.5).at), ElementsAre(near(0.5)));
    // A line that runs to 4 and back to 2: x = 8 t - 6 t^2.
    const Arc turning = plainArc(Points{{0, 0}, {4, 0}, {2, 0}});
    EXPECT_THAT(passages(turning, {2, 0}), ElementsAre(near(1.0 / 3), near(1)));
    EXPECT_THAT(passages(turning, {1, 0}), ElementsAre(near((4 - std::sqrt(10.0)) / 6)));
}

TEST(Passages, areToldAtTheEnds) {
    const Arc arch = plainArc(kArch);
    EXPECT_THAT(passages(arch, arch.front()), ElementsAre(near(0, 0)));
    EXPECT_THAT(passages(arch, arch.back()), ElementsAre(near(1, 0)));
    const Arc ring = plainArc(Points{{0, 0}, {2, 0}, {0, 2}, {0, 0}});
    EXPECT_THAT(passages(ring, {0, 0}), ElementsAre(near(0, 0), near(1, 0)));
}

TEST(Passages, areThoseWithinTheGap) {
    const Arc arch = plainArc(kArch); // its top, (2, 3), is at 1/2
    for (const double gap : {1e-3, 1e-6, 1e-9}) {
        EXPECT_THAT(passages(arch, {2, 3 + 0.99 * gap}, gap), ElementsAre(near(0.5, 1e-6))) << gap;
        EXPECT_THAT(passages(arch, {2, 3 + 1.01 * gap}, gap), IsEmpty()) << gap;
        EXPECT_THAT(passages(arch, {2, 3 - 1.01 * gap}, gap), IsEmpty()) << gap;
        EXPECT_THAT(passages(arch, {-1.01 * gap, 0}, gap), IsEmpty()) << gap;
    }
}

TEST(Passages, haveTheParametersOfTheSegment) {
    const Arc stretch = part(plainArc(kArch), 0.25, 0.75);
    EXPECT_THAT(passages(stretch, {2, 3}), ElementsAre(near(0.5)));
    EXPECT_THAT(passages(stretch, stretch.front()), ElementsAre(near(0.25)));
    EXPECT_THAT(passages(stretch, {0, 0}), IsEmpty()) << "which is of the segment, not of its part";
}

TEST(Passages, ofOnePointAreOne) {
    EXPECT_EQ(passages(plainArc(Points(3, Point{1, 1})), {1, 1}).size(), 1U);
    EXPECT_THAT(passages(plainArc(Points(3, Point{1, 1})), {1, 2}), IsEmpty());
}

TEST(Passages, areNotLookedForOnceTheBudgetHasEnded) {
    WorkBudget none(0);
    EXPECT_THAT(passagesThrough(plainArc(kArch), {2, 3}, kTouching, none), IsEmpty());
    EXPECT_EQ(none.end(), WorkEnd::beyondBudget);
}

RC_GTEST_PROP(TouchBetween, areStretchesOfOneCurve, ()) {
    const Points segment = *test::anyBentCurve(2, 4);
    const Arc a = arcOf(segment, test::kFrame), b = arcOf(elevated(segment, 1), test::kFrame);
    const auto [from, to] = *test::anyStretch();
    RC_ASSERT(areTouching(a, b, {from, from}, {to, to}));
    RC_ASSERT(areTouching(a, b, {to, to}, {from, from}));
    const Arc back = arcOf(Points(segment.rbegin(), segment.rend()), test::kFrame);
    RC_ASSERT(areTouching(a, back, {from, 1 - from}, {to, 1 - to}));
}

TEST(TouchBetween, areNotCurvesThatPartBetweenTheirContacts) {
    const Arc arch = plainArc(kArch), floor = plainArc(Points{{0, 0}, {4, 0}});
    EXPECT_FALSE(areTouching(arch, floor, {0, 0}, {1, 1}));
    EXPECT_TRUE(areTouching(arch, floor, {0, 0}, {0, 0})) << "one place";
    EXPECT_TRUE(areTouching(arch, floor, {0, 0}, {1, 1}, 3.1)) << "never farther than that";
    const Arc above = plainArc(Points{{-1, 3 + 1e-11}, {5, 3 + 1e-11}});
    EXPECT_FALSE(areTouching(arch, above, {0.499, 0.499}, {0.501, 0.501}));
}

TEST(TouchBetween, areCurvesThatRunOnTogetherOnBoth) {
    // Both places lie on the loop, but it runs around in between.
    const double h = std::sqrt(21.0) / 14;
    const Arc loop = plainArc(kLoop), cross = plainArc(Points{{1, 2}, {3, 2}});
    EXPECT_FALSE(areTouching(loop, cross, {0.5 - h, 0.5}, {0.5 + h, 0.5}));
}

} // namespace
} // namespace kriva
