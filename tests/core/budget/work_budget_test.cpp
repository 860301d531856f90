#include "core/budget/work_budget.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

TEST(WorkBudget, lastsForItsStepsAndEndsForGood) {
    WorkBudget budget(3);
    EXPECT_TRUE(budget.spend(2));
    EXPECT_FALSE(budget.end());
    EXPECT_FALSE(budget.spend(2));
    EXPECT_FALSE(budget.spend(1)) << "one step was left, but the work has ended";
    EXPECT_EQ(budget.end(), WorkEnd::beyondBudget);
}

TEST(WorkBudget, endsWhereSomebodyAsksIt) {
    std::stop_source stop;
    WorkBudget budget(WorkBudget::kUnlimited, stop.get_token());
    EXPECT_TRUE(budget.spend());
    stop.request_stop();
    EXPECT_FALSE(budget.spend());
    EXPECT_EQ(budget.end(), WorkEnd::stopped);
}

TEST(WorkBudget, mayEndForAReasonOfTheWork) {
    WorkBudget budget;
    budget.endFor(WorkEnd::tooMuchFound);
    EXPECT_FALSE(budget.spend());
    budget.endFor(WorkEnd::stopped);
    EXPECT_EQ(budget.end(), WorkEnd::tooMuchFound) << "the first reason stays";
}

TEST(WorkBudget, countsWhatIsAskedForAfterTheEndToo) {
    WorkBudget budget(3);
    EXPECT_TRUE(budget.spend(3));
    EXPECT_FALSE(budget.spend(2));
    EXPECT_FALSE(budget.spend(2));
    EXPECT_EQ(budget.spent(), 7U);
}

TEST(WorkBudget, ofNoLimitGivesWhatTheWorkMakes) {
    EXPECT_EQ(withoutLimit([](WorkBudget& budget) { return budget.spend() ? std::optional(5) : std::nullopt; }), 5);
}

} // namespace
} // namespace kriva
