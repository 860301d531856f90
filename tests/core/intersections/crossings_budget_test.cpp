#include "core/intersections/crossings.h"
#include "tests/support/long_run.h"

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

namespace kriva {
namespace {

using testing::SizeIs;

using Chain = std::vector<Points>;

constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

/// What is still asked for after the end, while the work finds its way out.
constexpr std::uint64_t kWayOut = 50'000;

std::vector<SegmentChain> chainsOf(const std::vector<Chain>& curves) {
    std::vector<SegmentChain> chains;
    for (const Chain& curve : curves)
        chains.push_back({curve, false});
    return chains;
}

Chain lineChain(Point from, Point to) {
    return {{from, to}};
}

/// Lines through one point.
std::vector<Chain> star(int count) {
    std::vector<Chain> curves;
    for (int i = 0; i < count; ++i) {
        const double angle = std::numbers::pi * i / count;
        const Vector way{std::cos(angle), std::sin(angle)};
        curves.push_back(lineChain(Point{} - way, Point{} + way));
    }
    return curves;
}

/// Lines along both axes: each of the ones crosses each of the others.
std::vector<Chain> grid(int count) {
    std::vector<Chain> curves;
    for (int i = 0; i < count; ++i) {
        const double at = i;
        curves.push_back(lineChain({at, -1}, {at, static_cast<double>(count)}));
        curves.push_back(lineChain({-1, at}, {static_cast<double>(count), at}));
    }
    return curves;
}

std::vector<Chain> copies(const Points& segment, std::size_t count) {
    return std::vector<Chain>(count, Chain{segment});
}

const Points kWave{{0, 0}, {2, 5}, {3, -6}, {7, 3}};

/// Cubics that are too close to each other to be told apart soon.
std::vector<Chain> nearlyOne(std::size_t count) {
    std::vector<Chain> curves = copies(kWave, count);
    for (std::size_t i = 0; i < count; ++i)
        curves[i][0][1].y += 1e-6 * static_cast<double>(i);
    return curves;
}

/// Segments of degree 5 that lie on themselves or nearly do, so that their double points are sought for long.
std::vector<Chain> folded(std::size_t count) {
    return copies({{0, 0}, {4, 1e-9}, {0, 3}, {1e-9, 3}, {8, 0}, {0, 0}}, count);
}

std::vector<std::vector<Chain>> longWork() {
    return {star(40), grid(20), copies(kWave, 4), copies({{0, 0}, {7, 3}}, 4), nearlyOne(2), folded(1)};
}

struct Outcome {
    std::optional<Crossings> found;
    std::optional<WorkEnd> end;
    std::uint64_t spent = 0;
};

Outcome outcomeOf(const std::vector<Chain>& curves, std::uint64_t steps, std::size_t mostPasses = kAnyNumber) {
    WorkBudget budget(steps);
    Outcome outcome;
    outcome.found = findCrossings(chainsOf(curves), budget, mostPasses);
    outcome.end = budget.end();
    outcome.spent = budget.spent();
    return outcome;
}

std::size_t passCount(const Crossings& crossings) {
    std::size_t count = 2 * crossings.overlaps.size();
    for (const Crossing& place : crossings.places)
        count += place.passes.size();
    return count;
}

TEST(CrossingsBudget, isEnoughToTheStepAndOneStepLessIsNot) {
    for (const std::vector<Chain>& curves : longWork()) {
        const Outcome whole = outcomeOf(curves, WorkBudget::kUnlimited);
        ASSERT_TRUE(whole.found);
        EXPECT_EQ(outcomeOf(curves, whole.spent).spent, whole.spent) << "the same steps each time";
        EXPECT_TRUE(outcomeOf(curves, whole.spent).found);
        const Outcome less = outcomeOf(curves, whole.spent - 1);
        EXPECT_FALSE(less.found);
        EXPECT_EQ(less.end, WorkEnd::beyondBudget);
    }
}

TEST(CrossingsBudget, endsTheWorkSoonWhereverItEnds) {
    for (const std::vector<Chain>& curves : longWork()) {
        const std::uint64_t whole = outcomeOf(curves, WorkBudget::kUnlimited).spent;
        for (int part = 0; part < 12; ++part) {
            const std::uint64_t steps = whole * static_cast<std::uint64_t>(part) / 12;
            const Outcome outcome = outcomeOf(curves, steps);
            EXPECT_FALSE(outcome.found);
            EXPECT_LE(outcome.spent, steps + kWayOut) << "of " << whole;
        }
    }
}

TEST(CrossingsBudget, aStopEndsTheWorkAsSoon) {
    std::stop_source stop;
    stop.request_stop();
    for (const std::vector<Chain>& curves : longWork()) {
        WorkBudget budget(WorkBudget::kUnlimited, stop.get_token());
        EXPECT_FALSE(findCrossings(chainsOf(curves), budget, kAnyNumber));
        EXPECT_EQ(budget.end(), WorkEnd::stopped);
        EXPECT_LE(budget.spent(), kWayOut);
    }
}

TEST(CrossingsBudget, passesAreLimitedToTheLastOne) {
    for (const std::vector<Chain>& curves : {star(20), grid(7), copies({{0, 0}, {7, 3}}, 6)}) {
        const std::size_t passes = passCount(findCrossings(chainsOf(curves)));
        EXPECT_TRUE(outcomeOf(curves, WorkBudget::kUnlimited, passes).found) << passes;
        const Outcome beyond = outcomeOf(curves, WorkBudget::kUnlimited, passes - 1);
        EXPECT_FALSE(beyond.found);
        EXPECT_EQ(beyond.end, WorkEnd::tooMuchFound);
    }
}

TEST(CrossingsBudget, allPassesThroughOnePlaceAreOnePlace) {
    const Crossings found = findCrossings(chainsOf(star(200)));
    ASSERT_THAT(found.places, SizeIs(1));
    EXPECT_THAT(found.places[0].passes, SizeIs(200));
}

TEST(CrossingsBudget, stepsGrowWithTheMeetingsInOnePlaceAndNotWithTheirSquare) {
    // Four times the lines are 16 times the meetings.
    const auto steps = [](int count) {
        return static_cast<double>(outcomeOf(star(count), WorkBudget::kUnlimited).spent);
    };
    EXPECT_LT(steps(120) / steps(30), 20);
}

TEST(CrossingsBudget, aMillionPassesAreFoundAndOneMoreIsTooMany) {
    if (!test::isLongRun())
        GTEST_SKIP() << "only in the long run";
    constexpr std::size_t kMost = 1'000'000;
    std::vector<Chain> curves = grid(707); // 999,698 passes
    for (int i = 0; i < 151; ++i)          // and 302 more, each in a place of its own far away
        for (const double side : {-1.0, 1.0})
            curves.push_back(lineChain({-10.0 - 3 * i, side}, {-9.0 - 3 * i, -side}));
    EXPECT_EQ(passCount(findCrossings(chainsOf(curves))), kMost);
    EXPECT_TRUE(outcomeOf(curves, WorkBudget::kUnlimited, kMost).found);
    curves.push_back(lineChain({-10, 1.5}, {-9, 1.5})); // meets nothing
    curves.push_back(lineChain({-9.75, 1}, {-9.75, 2}));
    EXPECT_EQ(outcomeOf(curves, WorkBudget::kUnlimited, kMost).end, WorkEnd::tooMuchFound);
}

} // namespace
} // namespace kriva
