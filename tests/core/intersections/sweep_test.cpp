#include "core/intersections/sweep.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <set>

namespace kriva {
namespace {

using testing::IsEmpty;
using testing::UnorderedElementsAre;

using IndexPair = std::pair<std::size_t, std::size_t>;

std::vector<IndexPair> overlapsOf(const std::vector<Box>& boxes, WorkBudget& budget) {
    std::vector<IndexPair> pairs;
    forEachOverlap(boxes, budget, [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); });
    return pairs;
}

std::vector<IndexPair> overlapsOf(const std::vector<Box>& boxes) {
    WorkBudget budget;
    return overlapsOf(boxes, budget);
}

/// Boxes in a small square of whole numbers: many share a side or a corner, some are points.
rc::Gen<std::vector<Box>> anyBoxes() {
    const auto side = rc::gen::pair(rc::gen::inRange(0, 12), rc::gen::inRange(0, 4));
    return rc::gen::container<std::vector<Box>>(rc::gen::map(rc::gen::pair(side, side), [](const auto& sides) {
        const auto [x, width] = sides.first;
        const auto [y, height] = sides.second;
        return Box{double(x), double(y), double(x + width), double(y + height)};
    }));
}

TEST(Sweep, tellsNoneOfFewerThanTwoBoxes) {
    EXPECT_THAT(overlapsOf({}), IsEmpty());
    EXPECT_THAT(overlapsOf({{0, 0, 1, 1}}), IsEmpty());
}

TEST(Sweep, tellsBoxesThatShareASideOrACornerOrAreOne) {
    const Box box{0, 0, 2, 2};
    for (const Box& other : {box, Box{2, 0, 3, 2}, Box{0, 2, 2, 3}, Box{2, 2, 3, 3}, Box{-1, 2, 0, 3}, Box{1, 1, 1, 1}})
        EXPECT_THAT(overlapsOf({other, box}), UnorderedElementsAre(IndexPair(0, 1)));
    for (const Box& other : {Box{3, 0, 4, 2}, Box{0, 3, 2, 4}, Box{-2, 0, -1, 2}, Box{0, -2, 2, -1}})
        EXPECT_THAT(overlapsOf({other, box}), IsEmpty());
}

TEST(Sweep, tellsNoneOfBoxesWithoutPoints) {
    EXPECT_THAT(overlapsOf({Box(), {-1, -1, 1, 1}, Box()}), IsEmpty());
}

RC_GTEST_PROP(Sweep, tellsEachPairThatOverlapsOnce, ()) {
    const std::vector<Box> boxes = *anyBoxes();
    std::vector<IndexPair> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
            if (overlap(boxes[i], boxes[j]))
                expected.emplace_back(i, j);
    std::vector<IndexPair> pairs = overlapsOf(boxes);
    std::ranges::sort(pairs);
    RC_ASSERT(pairs == expected);
}

RC_GTEST_PROP(Sweep, hasToldAllPairsUnlessTheBudgetHasEnded, ()) {
    const std::vector<Box> boxes = *anyBoxes();
    WorkBudget unlimited;
    const std::vector<IndexPair> all = overlapsOf(boxes, unlimited);
    WorkBudget budget(*rc::gen::inRange<std::uint64_t>(0, unlimited.spent() + 1));
    const std::vector<IndexPair> told = overlapsOf(boxes, budget);
    RC_ASSERT(std::set(told.begin(), told.end()).size() == told.size());
    for (const IndexPair& pair : told)
        RC_ASSERT(std::ranges::count(all, pair) == 1);
    RC_ASSERT(budget.end() || told.size() == all.size());
}

TEST(Sweep, tellsNoMoreOnceItsListenerHasEndedTheBudget) {
    const std::vector<Box> boxes(20, Box{0, 0, 1, 1});
    WorkBudget budget;
    std::size_t told = 0;
    forEachOverlap(boxes, budget, [&](std::size_t, std::size_t) {
        if (++told == 7)
            budget.endFor(WorkEnd::tooMuchFound);
    });
    EXPECT_EQ(told, 7U);
}

TEST(Sweep, takesStepsForBoxesAndForThoseBesideThemAlone) {
    const auto steps = [](std::size_t count) {
        std::vector<Box> row;
        for (std::size_t i = 0; i < count; ++i)
            row.push_back({double(i), 0, double(i) + 0.5, 1});
        WorkBudget budget;
        EXPECT_THAT(overlapsOf(row, budget), IsEmpty());
        return budget.spent();
    };
    EXPECT_LE(steps(40'000), 4 * steps(10'000) + 100);
}

} // namespace
} // namespace kriva
