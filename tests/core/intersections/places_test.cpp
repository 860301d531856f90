#include "core/bezier/evaluate.h"
#include "core/intersections/places.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace kriva {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kApart = 1e-6; // places closer than this are one

using Polylines = std::vector<std::vector<Points>>;

/// The segments of polylines.
Polylines chainsThrough(const std::vector<Points>& lines) {
    Polylines chains;
    for (const Points& line : lines) {
        chains.emplace_back();
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            chains.back().push_back({line[i], line[i + 1]});
    }
    return chains;
}

std::vector<Crossing> placesOf(const Polylines& chains, const std::vector<Meeting>& meetings, bool closed = false) {
    std::vector<SegmentChain> parts;
    for (const std::vector<Points>& chain : chains)
        parts.push_back({chain, closed});
    WorkBudget budget;
    return unitedPlaces(parts, meetings, kApart, budget);
}

/// A star of lines through the origin, each from -1 to 1: t = 1/2 is there.
Polylines starOf(std::size_t count) {
    std::vector<Points> lines;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = 1 - 2 * static_cast<double>(i) / static_cast<double>(count);
        lines.push_back({{-x, -1}, {x, 1}});
    }
    return chainsThrough(lines);
}

const Polylines kRow = chainsThrough({{{0, 0}, {1, 0}, {2, 0}, {3, 0}}, {{0, -1}, {3, 1}}});

TEST(Places, areNoneWithoutMeetings) {
    EXPECT_THAT(placesOf({}, {}), IsEmpty());
    EXPECT_THAT(placesOf(kRow, {}), IsEmpty());
}

TEST(Places, haveTheirPassesInOrderAndAreWhereTheFirstOneIs) {
    const std::vector<Crossing> places = placesOf(kRow, {{{1, 0, 0.5}, {0, 1, 0.5}}});
    ASSERT_THAT(places, SizeIs(1));
    EXPECT_THAT(places[0].passes, ElementsAre(Pass{0, 1, 0.5}, Pass{1, 0, 0.5}));
    EXPECT_EQ(places[0].at, (Point{1.5, 0}));
}

TEST(Places, areInTheOrderOfTheirFirstPass) {
    const std::vector<Crossing> places =
        placesOf(kRow, {{{0, 2, 0.25}, {1, 0, 0.75}}, {{1, 0, 0.125}, {0, 0, 0.375}}, {{0, 0, 0.75}, {1, 0, 0.25}}});
    ASSERT_THAT(places, SizeIs(3));
    EXPECT_EQ(places[0].passes.front(), (Pass{0, 0, 0.375}));
    EXPECT_EQ(places[1].passes.front(), (Pass{0, 0, 0.75}));
    EXPECT_EQ(places[2].passes.front(), (Pass{0, 2, 0.25}));
}

TEST(Places, ofManyPassesAreOne) {
    std::vector<Meeting> meetings;
    for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t j = i + 1; j < 5; ++j)
            meetings.push_back({{i, 0, 0.5}, {j, 0, 0.5}});
    const std::vector<Crossing> places = placesOf(starOf(5), meetings);
    ASSERT_THAT(places, SizeIs(1));
    EXPECT_THAT(places[0].passes, SizeIs(5));
}

TEST(Places, closerThanTheDistanceAreOneInAChainToo) {
    // Lines that cross the first one at 0.5, and a little farther each time.
    const auto placesApart = [](double step) {
        std::vector<Points> lines{{{0, 0}, {1, 0}}};
        std::vector<Meeting> meetings;
        for (std::size_t i = 0; i < 4; ++i) {
            const double x = 0.5 + step * static_cast<double>(i);
            lines.push_back({{x, -1}, {x, 1}});
            meetings.push_back({{0, 0, x}, {i + 1, 0, 0.5}});
        }
        return placesOf(chainsThrough(lines), meetings);
    };
    EXPECT_THAT(placesApart(0.99 * kApart), SizeIs(1));
    EXPECT_THAT(placesApart(0.99 * kApart)[0].passes, SizeIs(5));
    EXPECT_THAT(placesApart(1.01 * kApart), SizeIs(4));
}

TEST(Places, tellAPassThroughAKnotAtTheSegmentThatStartsThere) {
    for (const double t : {1.0, 1 - 1e-12}) {
        const std::vector<Crossing> places = placesOf(kRow, {{{0, 0, t}, {1, 0, 1.0 / 3}}});
        ASSERT_THAT(places, SizeIs(1));
        EXPECT_EQ(places[0].passes[0], (Pass{0, 1, 0})) << t;
    }
    const std::vector<Crossing> atStart = placesOf(kRow, {{{0, 2, 1e-12}, {1, 0, 2.0 / 3}}});
    ASSERT_THAT(atStart, SizeIs(1));
    EXPECT_EQ(atStart[0].passes[0], (Pass{0, 2, 0}));
}

TEST(Places, tellAPassAtAnOpenEndThere) {
    const Polylines lines = chainsThrough({{{0, 0}, {1, 0}}, {{1, -1}, {1, 1}}});
    const std::vector<Crossing> open = placesOf(lines, {{{0, 0, 1}, {1, 0, 0.5}}});
    ASSERT_THAT(open, SizeIs(1));
    EXPECT_EQ(open[0].passes[0], (Pass{0, 0, 1}));
}

TEST(Places, tellAPassThroughTheKnotOfAClosedChainAtItsStart) {
    const Polylines lines = chainsThrough({{{0, 0}, {1, 0}, {0, 1}, {0, 0}}, {{-1, -1}, {1, 1}, {-1, -1}}});
    const std::vector<Crossing> closed = placesOf(lines, {{{0, 2, 1}, {1, 0, 0.5}}}, true);
    ASSERT_THAT(closed, SizeIs(1));
    EXPECT_EQ(closed[0].passes[0], (Pass{0, 0, 0}));
}

TEST(Places, leaveOutSegmentsOfOnePointAtKnots) {
    Polylines chains = chainsThrough({{{0, 0}, {1, 0}, {1, 0}, {2, 0}}, {{1, -1}, {1, 1}}});
    const std::vector<Crossing> places = placesOf(chains, {{{0, 0, 1}, {1, 0, 0.5}}});
    ASSERT_THAT(places, SizeIs(1));
    EXPECT_EQ(places[0].passes[0], (Pass{0, 2, 0}));
}

TEST(Places, tellOncePassesThatRunIntoEachOther) {
    // Told on both sides of the knot, and twice a little apart.
    const std::vector<Crossing> places = placesOf(
        kRow, {{{0, 0, 1 - 1e-7}, {1, 0, 1.0 / 3}}, {{0, 1, 1e-7}, {1, 0, 1.0 / 3}}, {{0, 1, 2e-7}, {1, 0, 1.0 / 3}}});
    ASSERT_THAT(places, SizeIs(1));
    EXPECT_THAT(places[0].passes, SizeIs(2));
}

TEST(Places, areNoneWhereOnlyOnePassIsLeft) {
    EXPECT_THAT(placesOf(kRow, {{{0, 0, 1}, {0, 1, 0}}}), IsEmpty());
    EXPECT_THAT(placesOf(kRow, {{{0, 0, 1 - 1e-7}, {0, 1, 1e-7}}}), IsEmpty());
    const Polylines ring = chainsThrough({{{0, 0}, {1, 0}, {0, 1}, {0, 0}}});
    EXPECT_THAT(placesOf(ring, {{{0, 0, 1e-7}, {0, 2, 1 - 1e-7}}}, true), IsEmpty()) << "around the start";
    EXPECT_THAT(placesOf(ring, {{{0, 0, 0}, {0, 2, 1}}}, false), SizeIs(1)) << "not closed, so its ends meet";
}

TEST(Places, keepPassesThatLeaveThePlaceInBetween) {
    // A chain that comes back to where it was.
    const Polylines bow = chainsThrough({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}});
    const std::vector<Crossing> places = placesOf(bow, {{{0, 0, 0.5}, {0, 2, 0.5}}});
    ASSERT_THAT(places, SizeIs(1));
    EXPECT_THAT(places[0].passes, ElementsAre(Pass{0, 0, 0.5}, Pass{0, 2, 0.5}));
}

TEST(Places, keepBothPassesOfALoopSmallerThanAPlace) {
    // A cusp opened so little that the loop is within the distance.
    const Points loop{{0, 0}, {1 + 1e-9, 1}, {0 - 1e-9, 1}, {1, 0}};
    const double h = 1e-5;
    const std::vector<Crossing> places = placesOf({{loop}}, {{{0, 0, 0.5 - h}, {0, 0, 0.5 + h}}});
    ASSERT_THAT(places, SizeIs(1));
    EXPECT_THAT(places[0].passes, ElementsAre(Pass{0, 0, 0.5 - h}, Pass{0, 0, 0.5 + h}));
}

TEST(Places, giveNothingUsefulOfAnEndedBudgetAndEndSoon) {
    const Polylines star = starOf(40);
    std::vector<SegmentChain> parts;
    for (const std::vector<Points>& chain : star)
        parts.push_back({chain, false});
    std::vector<Meeting> meetings;
    for (std::size_t i = 0; i < 40; ++i)
        for (std::size_t j = i + 1; j < 40; ++j)
            meetings.push_back({{i, 0, 0.5}, {j, 0, 0.5}});
    WorkBudget whole;
    EXPECT_THAT(unitedPlaces(parts, meetings, kApart, whole), SizeIs(1));
    WorkBudget enough(whole.spent());
    EXPECT_THAT(unitedPlaces(parts, meetings, kApart, enough), SizeIs(1));
    EXPECT_FALSE(enough.end());
    WorkBudget none(0);
    EXPECT_THAT(unitedPlaces(parts, meetings, kApart, none), IsEmpty());
    EXPECT_EQ(none.end(), WorkEnd::beyondBudget);
}

/// Meetings of lines in a square of whole numbers, many in one place.
struct Lattice {
    Polylines lines;
    std::vector<Meeting> meetings;
};

Lattice anyLattice() {
    std::vector<Points> lines;
    const auto count = *rc::gen::inRange<std::size_t>(2, 8);
    for (std::size_t i = 0; i < count; ++i) {
        const double from = *rc::gen::inRange(0, 6), to = *rc::gen::inRange(0, 6);
        lines.push_back(*rc::gen::arbitrary<bool>() ? Points{{0, from}, {6, to}} : Points{{from, 0}, {to, 6}});
    }
    Lattice lattice{chainsThrough(lines), {}};
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j) {
            const Vector u = lines[i][1] - lines[i][0], v = lines[j][1] - lines[j][0], gap = lines[j][0] - lines[i][0];
            const double turn = cross(u, v);
            if (turn == 0)
                continue;
            const double t = cross(gap, v) / turn, s = cross(gap, u) / turn;
            if (t >= 0 && t <= 1 && s >= 0 && s <= 1)
                lattice.meetings.push_back({{i, 0, t}, {j, 0, s}});
        }
    return lattice;
}

RC_GTEST_PROP(Places, haveAllPassesOfTheirMeetingsAndNoOthers, ()) {
    const Lattice lattice = anyLattice();
    const Polylines& lines = lattice.lines;
    const std::vector<Crossing> places = placesOf(lines, lattice.meetings);
    const auto wayOf = [&](const Pass& pass) { return lines[pass.curve][0][1] - lines[pass.curve][0][0]; };
    std::size_t meetingsAtPlaces = 0;
    for (const Crossing& place : places) {
        RC_ASSERT(place.passes.size() >= 2);
        RC_ASSERT(std::ranges::is_sorted(place.passes));
        RC_ASSERT(std::ranges::adjacent_find(place.passes) == place.passes.end());
        for (const Pass& pass : place.passes)
            RC_ASSERT(distance(evaluate(lines[pass.curve][pass.segment], pass.t), place.at) <= kApart);
        for (const Pass& one : place.passes) // of lines each two that are not parallel meet once
            for (const Pass& other : place.passes)
                meetingsAtPlaces += one.curve < other.curve && cross(wayOf(one), wayOf(other)) != 0;
    }
    RC_ASSERT(meetingsAtPlaces == lattice.meetings.size());
}

RC_GTEST_PROP(Places, doNotDependOnTheOrderOfMeetings, ()) {
    const auto [lines, meetings] = anyLattice();
    std::vector<Meeting> others(meetings.rbegin(), meetings.rend());
    for (std::size_t i = 0; i < others.size(); i += 2)
        std::swap(others[i].one, others[i].other);
    const std::vector<Crossing> places = placesOf(lines, meetings), again = placesOf(lines, others);
    RC_ASSERT(places.size() == again.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        RC_ASSERT(distance(places[i].at, again[i].at) <= kApart);
        RC_ASSERT(places[i].passes.size() == again[i].passes.size());
        for (std::size_t k = 0; k < places[i].passes.size(); ++k) {
            RC_ASSERT(places[i].passes[k].curve == again[i].passes[k].curve);
            RC_ASSERT(std::abs(places[i].passes[k].t - again[i].passes[k].t) <= 1e-12);
        }
    }
}

} // namespace
} // namespace kriva
