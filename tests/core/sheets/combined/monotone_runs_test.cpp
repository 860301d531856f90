#include "core/sheets/combined/monotone_runs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>

namespace kriva {
namespace {

using ::testing::ElementsAre;

std::vector<MonotoneRun> runsOf(std::initializer_list<double> places) {
    Points points;
    for (const double x : places)
        points.push_back({x, static_cast<double>(points.size())});
    return monotoneRuns(points);
}

RC_GTEST_PROP(MonotoneRuns, holdEveryPointOnceInStrictOrder, (const std::vector<short>& places)) {
    Points points;
    for (const short x : places)
        points.push_back({static_cast<double>(x % 8), 0});
    int next = 0;
    for (const MonotoneRun& run : monotoneRuns(points)) {
        RC_ASSERT(run.first == next);
        next = run.last + 1;
        const std::span<const Point> own = pointsOf(run, points);
        RC_ASSERT((own.size() == 1) == (run.direction == 0));
        for (std::size_t i = 1; i < own.size(); ++i)
            RC_ASSERT((own[i].x - own[i - 1].x) * run.direction > 0);
    }
    RC_ASSERT(static_cast<std::size_t>(next) == points.size());
}

TEST(MonotoneRuns, leaveTheTurningPointWithTheRunBefore) {
    EXPECT_THAT(runsOf({0, 1, 2, 1, 0}), ElementsAre(MonotoneRun{0, 2, 1}, MonotoneRun{3, 4, -1}));
}

TEST(MonotoneRuns, takeTheirDirectionFromTheirOwnFirstStep) {
    EXPECT_THAT(runsOf({0, 1, 0.5, 2}), ElementsAre(MonotoneRun{0, 1, 1}, MonotoneRun{2, 3, 1}));
}

TEST(MonotoneRuns, startAnewWhereXStays) {
    EXPECT_THAT(runsOf({0, 0, 0, -1}), ElementsAre(MonotoneRun{0, 0, 0}, MonotoneRun{1, 1, 0}, MonotoneRun{2, 3, -1}));
}

TEST(MonotoneRuns, areNoneWithoutPointsAndOneOfOnePoint) {
    EXPECT_TRUE(runsOf({}).empty());
    EXPECT_THAT(runsOf({7}), ElementsAre(MonotoneRun{0, 0, 0}));
}

} // namespace
} // namespace kriva
