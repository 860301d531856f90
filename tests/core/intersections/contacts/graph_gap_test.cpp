#include "core/intersections/contacts/graph_gap.h"
#include "tests/core/intersections/arcs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>

namespace kriva {
namespace {

using test::kTouching;
using test::plainArc;
using testing::IsEmpty;
using testing::SizeIs;

std::optional<GraphGap> gapBetween(const Arc& a, const Arc& b) {
    WorkBudget budget;
    return GraphGap::between(a, b, budget);
}

/// Of arcs that are graphs over each other.
std::optional<std::vector<Contact>> contactsOf(const Arc& a, const Arc& b) {
    WorkBudget budget;
    const auto gap = GraphGap::between(a, b, budget);
    EXPECT_TRUE(gap);
    return gap ? gap->contacts(kTouching, budget) : std::vector<Contact>();
}

/// Along the x axis from 0 to 1.
const Arc kFloor = plainArc(Points{{0, 0}, {1, 0}});

/// y = c (x - r) (x - s) from 0 to 1.
Arc parabola(double c, double r, double s) {
    return plainArc(Points{{0, c * r * s}, {0.5, c * (r * s - (r + s) / 2)}, {1, c * (1 - r) * (1 - s)}});
}

double anyRoot() {
    return *rc::gen::inRange(-8, 41) / 32.0;
}

TEST(GraphGap, isBetweenArcsThatRunAlongTheChordOfTheFirst) {
    EXPECT_TRUE(gapBetween(kFloor, plainArc(Points{{0, 1}, {0.2, 3}, {1, 2}})));
    EXPECT_TRUE(gapBetween(kFloor, plainArc(Points{{1, 2}, {0.2, 3}, {0, 1}}))) << "the other way round";
    EXPECT_FALSE(gapBetween(kFloor, plainArc(Points{{0, 1}, {1.2, 3}, {1, 2}}))) << "turns back";
    EXPECT_FALSE(gapBetween(plainArc(Points{{0, 1}, {1.2, 3}, {1, 2}}), kFloor));
    EXPECT_FALSE(gapBetween(kFloor, plainArc(Points{{0, 1}, {0, 2}, {1, 2}}))) << "rises upright";
    EXPECT_FALSE(gapBetween(plainArc(Points{{0, 0}, {1, 1}, {0, 0}}), kFloor)) << "has no chord";
    EXPECT_FALSE(gapBetween(plainArc(Points(3, Point{0, 0})), kFloor));
}

RC_GTEST_PROP(GraphGap, closesAtTheRootsOfAParabola, ()) {
    const double c = *rc::gen::elementOf(std::vector{-2.0, -1.0, -0.125, 0.125, 1.0, 2.0});
    const double r = anyRoot(), s = anyRoot();
    std::vector<double> expected;
    for (const double root : r == s ? std::vector{r} : std::vector{std::min(r, s), std::max(r, s)})
        if (root >= 0 && root <= 1)
            expected.push_back(root);
    const bool isBackwards = *rc::gen::arbitrary<bool>();
    const Arc other = isBackwards ? reversed(parabola(c, r, s)) : parabola(c, r, s);
    const auto found = contactsOf(kFloor, other);
    RC_ASSERT(found.has_value());
    RC_ASSERT(found->size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        RC_ASSERT(std::abs((*found)[i].a - expected[i]) <= 1e-12);
        RC_ASSERT(std::abs((*found)[i].b - expected[i]) <= 1e-12);
    }
}

RC_GTEST_PROP(GraphGap, closesOnceWhereLinesCross, ()) {
    const double left = *rc::gen::inRange(-16, 17) / 16.0, right = *rc::gen::inRange(-16, 17) / 16.0;
    RC_PRE(left != right);
    const auto found = contactsOf(kFloor, plainArc(Points{{0, left}, {1, right}}));
    RC_ASSERT(found.has_value());
    if (left * right > 0) {
        RC_ASSERT(found->empty());
        return;
    }
    RC_ASSERT(found->size() == 1);
    RC_ASSERT(std::abs((*found)[0].a - left / (left - right)) <= 1e-14);
    RC_ASSERT(std::abs((*found)[0].b - left / (left - right)) <= 1e-14);
}

TEST(GraphGap, closesOnceWhereArcsAreParallelAndTouch) {
    for (const double gap : {0.0, 0.9e-12, -0.9e-12}) {
        const auto found = contactsOf(kFloor, plainArc(Points{{0, 0.25 + gap}, {0.5, -0.25 + gap}, {1, 0.25 + gap}}));
        ASSERT_TRUE(found);
        ASSERT_THAT(*found, SizeIs(1)) << gap;
        EXPECT_NEAR((*found)[0].a, 0.5, 1e-12);
    }
    const auto apart =
        contactsOf(kFloor, plainArc(Points{{0, 0.25 + 1.1e-12}, {0.5, -0.25 + 1.1e-12}, {1, 0.25 + 1.1e-12}}));
    ASSERT_TRUE(apart);
    EXPECT_THAT(*apart, IsEmpty());
    const auto twice =
        contactsOf(kFloor, plainArc(Points{{0, 0.25 - 1.1e-12}, {0.5, -0.25 - 1.1e-12}, {1, 0.25 - 1.1e-12}}));
    ASSERT_TRUE(twice);
    EXPECT_THAT(*twice, SizeIs(2));
}

TEST(GraphGap, closesNowhereOfArcsSideBySide) {
    const Points arch{{0, 0}, {0.3, 0.4}, {0.7, 0.5}, {1, 0}};
    for (const double gap : {1e-3, 1e-6, 1e-11}) {
        Points above = arch;
        for (Point& p : above)
            p.y += gap;
        const auto found = contactsOf(plainArc(arch), plainArc(above));
        EXPECT_TRUE(!found || found->empty()) << gap;
    }
    EXPECT_THAT(contactsOf(kFloor, plainArc(Points{{2, -1}, {2.5, 3}, {3, 1}})).value(), IsEmpty())
        << "one after the other";
}

TEST(GraphGap, leavesOpenWhatItsBoundsDoNotTell) {
    // (x - 1/2)^3 and a little lower: three roots or one.
    const Arc wave = plainArc(Points{{0, -0.125}, {1.0 / 3, 0.125}, {2.0 / 3, -0.125}, {1, 0.125}});
    EXPECT_FALSE(contactsOf(kFloor, wave));
    EXPECT_FALSE(contactsOf(kFloor, kFloor)) << "one line";
}

TEST(GraphGap, hasTheParametersOfTheSegments) {
    const Arc floor = part(kFloor, 0.25, 1), other = part(parabola(1, 0.5, 2), 0.375, 0.75);
    const auto found = contactsOf(floor, other);
    ASSERT_TRUE(found);
    ASSERT_THAT(*found, SizeIs(1));
    EXPECT_NEAR((*found)[0].a, 0.5, 1e-14);
    EXPECT_NEAR((*found)[0].b, 0.5, 1e-14);
    const auto turned = contactsOf(floor, reversed(other));
    ASSERT_TRUE(turned);
    ASSERT_THAT(*turned, SizeIs(1));
    EXPECT_NEAR((*turned)[0].b, 0.5, 1e-14);
}

RC_GTEST_PROP(GraphGap, tellsContactsThatAreSome, ()) {
    const Arc a = *test::anyArc(), b = *test::anyArc();
    WorkBudget budget;
    const auto gap = GraphGap::between(a, b, budget);
    if (!gap)
        return;
    const auto found = gap->contacts(kTouching, budget);
    if (!found)
        return;
    RC_ASSERT(found->size() <= 2);
    for (const Contact& contact : *found)
        RC_ASSERT(gapAt(a, b, contact) <= kTouching);
}

TEST(GraphGap, isWithinWhatTheArcsKeep) {
    const auto beside = gapBetween(kFloor, plainArc(Points{{0, 0.5}, {1, 0.5}}));
    ASSERT_TRUE(beside);
    EXPECT_TRUE(beside->isWithin(0.5));
    EXPECT_FALSE(beside->isWithin(0.49));
    const auto closing = gapBetween(kFloor, plainArc(Points{{0, 0}, {1, 0.5}}));
    ASSERT_TRUE(closing);
    EXPECT_TRUE(closing->isWithin(0.5));
    EXPECT_FALSE(closing->isWithin(0.49));
    const auto elsewhere = gapBetween(kFloor, plainArc(Points{{2, 0}, {3, 0}}));
    ASSERT_TRUE(elsewhere);
    EXPECT_FALSE(elsewhere->isWithin(100)) << "they share no x";
}

RC_GTEST_PROP(GraphGap, isWithinOnlyWhatTheArcsKeep, ()) {
    // Both from 0 to 1 along x, so that the same t is the same x.
    const auto any = [] {
        Points points;
        for (int i = 0; i <= 4; ++i)
            points.push_back({i / 4.0, *rc::gen::inRange(-16, 17) / 64.0});
        return points;
    };
    Points one = any();
    const Points other = any();
    one.back().y = one.front().y; // its chord runs along x
    const Arc a = plainArc(one), b = plainArc(other);
    const auto gap = gapBetween(a, b);
    RC_ASSERT(gap.has_value());
    double widest = 0;
    for (int i = 0; i <= 64; ++i)
        widest = std::max(widest, gapAt(a, b, {i / 64.0, i / 64.0}));
    RC_ASSERT(!gap->isWithin(widest * (1 - 1e-9) - 1e-12));
}

TEST(GraphGap, isNotLookedForOnceTheBudgetHasEnded) {
    WorkBudget none(0);
    EXPECT_FALSE(GraphGap::between(kFloor, parabola(1, 0.25, 0.75), none));
    EXPECT_EQ(none.end(), WorkEnd::beyondBudget);
}

} // namespace
} // namespace kriva
