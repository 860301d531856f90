#include "core/bezier/elevate.h"
#include "core/bezier/evaluate.h"
#include "core/bezier/reduce.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

/// The squared distance integrated over the parameter, by Simpson's rule.
double squaredDistance(const Points& a, const Points& b) {
    constexpr int kSteps = 400;
    double sum = 0;
    for (int i = 0; i <= kSteps; ++i) {
        const double t = static_cast<double>(i) / kSteps;
        const Vector gap = evaluate(a, t) - evaluate(b, t);
        sum += (i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2) * dot(gap, gap);
    }
    return sum / (3 * kSteps);
}

TEST(Reduce, aParabolaBecomesItsChord) {
    const auto result = reduced(Points{{0, 0}, {1, 2}, {2, 0}});
    ASSERT_TRUE(result);
    EXPECT_EQ(result->points, (Points{{0, 0}, {2, 0}}));
    EXPECT_EQ(result->maxDeviation, 1);
}

TEST(Reduce, needsAnInnerPoint) {
    EXPECT_FALSE(reduced(Points{{1, 1}}));
    EXPECT_FALSE(reduced(Points{{1, 1}, {2, 2}}));
}

TEST(Reduce, ofRepeatedPointsIsThatPoint) {
    const auto result = reduced(Points(5, Point{0.1, 1e9}));
    EXPECT_EQ(result->points, Points(4, Point{0.1, 1e9}));
    EXPECT_EQ(result->maxDeviation, 0);
}

TEST(Reduce, undoesAnElevationAtDegree200) {
    Points curve(200);
    for (std::size_t i = 0; i < curve.size(); ++i)
        curve[i] = {static_cast<double>(i % 7), static_cast<double>(i % 5)};
    const auto result = reduced(elevated(curve, 1));
    for (std::size_t i = 0; i < curve.size(); ++i)
        EXPECT_LE(distance(result->points[i], curve[i]), 1e-11);
    EXPECT_LE(result->maxDeviation, 1e-13);
}

RC_GTEST_PROP(Reduce, undoesAnElevation, ()) {
    const Points curve = *test::anyCurve(1, 15);
    const auto result = reduced(elevated(curve, 1));
    for (std::size_t i = 0; i < curve.size(); ++i)
        RC_ASSERT(distance(result->points[i], curve[i]) <= 1e-9);
}

RC_GTEST_PROP(Reduce, keepsTheEndsAndTellsTheDeviation, ()) {
    const Points curve = *test::anyCurve(2, 12);
    const auto result = reduced(curve);
    RC_ASSERT(result->points.size() == curve.size() - 1);
    RC_ASSERT(result->points.front() == curve.front());
    RC_ASSERT(result->points.back() == curve.back());
    double largest = 0;
    for (int i = 0; i <= 1000; ++i)
        largest = std::max(largest, distance(evaluate(curve, i / 1000.0), evaluate(result->points, i / 1000.0)));
    RC_ASSERT(largest <= result->maxDeviation + 1e-9);
    RC_ASSERT(largest >= 0.999 * result->maxDeviation - 1e-9);
}

RC_GTEST_PROP(Reduce, isTheLeastSquaredDistance, ()) {
    const Points curve = *test::anyCurve(3, 8);
    Points best = reduced(curve)->points;
    const double least = squaredDistance(curve, best);
    const std::size_t moved = *rc::gen::inRange<std::size_t>(1, best.size() - 1);
    for (const Vector step : {Vector{1, 0}, Vector{-1, 0}, Vector{0, 1}, Vector{0, -1}}) {
        best[moved] = best[moved] + step;
        RC_ASSERT(squaredDistance(curve, best) > least);
        best[moved] = best[moved] - step;
    }
}

} // namespace
} // namespace kriva
