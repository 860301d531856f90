#include "core/bezier/measures/curvature.h"
#include "core/sheets/spline/spline_measures.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

TEST(SplineMeasures, findTheLargestCurvature) {
    SplineCurve chain;
    for (const Point p : Points{{0, 0}, {3, 2}, {5, 0}, {6, 4}})
        chain.knots.push_back({p, SplineKnot::Join::automatic, {}, {}});
    double sampled = 0;
    for (const Points& segment : segmentsOf(chain))
        for (int i = 0; i <= 10'000; ++i)
            sampled = std::max(sampled, std::abs(curvature(segment, i / 1e4).value_or(0)));
    WorkBudget budget;
    const double largest = largestCurvature(chain, budget).value();
    EXPECT_GE(largest, sampled * (1 - 1e-12));
    EXPECT_LE(largest, sampled * (1 + 1e-6));
}

} // namespace
} // namespace kriva
