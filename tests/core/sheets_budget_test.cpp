#include "core/document/document.h"
#include "core/document/methods.h"
#include "core/document/sheet_figure.h"
#include "core/sheets/combined/combined.h"
#include "core/sheets/elevation/elevation.h"
#include "core/sheets/spline/spline.h"
#include "core/sheets/subdivision/subdivision.h"

#include <gtest/gtest.h>

#include <functional>

namespace kriva {
namespace {

/// What is worked out beside the hand: whether it came to an end within the budget.
using Work = std::function<bool(WorkBudget&)>;

template <class C>
std::vector<Work> workOn(const C& curve) {
    return {[=](WorkBudget& budget) { return results(Curve(curve), budget).has_value(); },
            [=](WorkBudget& budget) { return plotsOf(curve, budget).has_value(); },
            [=](WorkBudget& budget) { return tablesOf(curve, budget).has_value(); },
            [=](WorkBudget& budget) { return drawn(Curve(curve), {}, budget).has_value(); }};
}

std::vector<Work> allWork() {
    const Points points{{0, 0}, {1, 2}, {2, 1}, {1, 3}, {3, 3}, {2, 0}, {5, 1}};
    ElevationCurve elevation;
    elevation.points = points;
    elevation.times = 20;
    SubdivisionCurve subdivision;
    subdivision.points = points;
    subdivision.multiplicity.assign(points.size(), 1);
    SplineCurve spline;
    for (const Point p : points)
        spline.knots.push_back({p, {}, {}, {}});
    CombinedCurve combined;
    combined.points = points;
    std::vector<Work> all;
    for (const std::vector<Work>& some : {workOn(elevation), workOn(subdivision), workOn(spline), workOn(combined)})
        all.insert(all.end(), some.begin(), some.end());
    all.push_back([=](WorkBudget& budget) { return compareMethods(combined, budget).has_value(); });
    return all;
}

TEST(LongWork, endsWhereverItsBudgetEnds) {
    for (const Work& work : allWork()) {
        WorkBudget whole;
        ASSERT_TRUE(work(whole));
        ASSERT_GT(whole.spent(), 0U);
        WorkBudget enough(whole.spent());
        EXPECT_TRUE(work(enough));
        for (std::uint64_t steps = 0; steps < whole.spent(); ++steps) {
            WorkBudget less(steps);
            EXPECT_FALSE(work(less)) << steps;
            EXPECT_LE(less.spent(), steps + 10) << "of " << whole.spent();
        }
    }
}

TEST(LongWork, aStopEndsItAtOnce) {
    std::stop_source stop;
    stop.request_stop();
    for (const Work& work : allWork()) {
        WorkBudget budget(WorkBudget::kUnlimited, stop.get_token());
        EXPECT_FALSE(work(budget));
        EXPECT_LE(budget.spent(), 10U);
    }
}

} // namespace
} // namespace kriva
