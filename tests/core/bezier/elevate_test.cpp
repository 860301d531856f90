#include "core/bezier/elevate.h"
#include "core/bezier/evaluate.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace kriva {
namespace {

TEST(Elevate, raisesACubicByTheTextbookFormula) {
    const Points curve{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    const Points raised{{0, 0}, {0.75, 1.5}, {2, 2}, {3.25, 1.5}, {4, 0}};
    EXPECT_EQ(elevated(curve, 1), raised);
}

TEST(Elevate, zeroTimesChangesNoBit) {
    const Points curve{{0.1, -0.0}, {1e9, 1e-9}, {0.3, 0.7}};
    EXPECT_EQ(elevated(curve, 0), curve);
    EXPECT_TRUE(std::signbit(elevated(curve, 0)[0].y));
}

TEST(Elevate, aSinglePointIsRepeated) {
    EXPECT_EQ(elevated(Points{{2, 3}}, 3), Points(4, Point{2, 3}));
    EXPECT_EQ(elevationGap(Points{{2, 3}}, 3), 0);
}

TEST(Elevate, staysFiniteAndMeetsTheEndsAtTheLimits) {
    Points curve(201);
    for (std::size_t i = 0; i < curve.size(); ++i)
        curve[i] = {i % 2 == 0 ? 1e9 : -1e9, static_cast<double>(i)};
    const Points raised = elevated(curve, 10000);
    ASSERT_EQ(raised.size(), 10201U);
    EXPECT_EQ(raised.front(), curve.front());
    EXPECT_EQ(raised.back(), curve.back());
    for (std::size_t i = 0; i < raised.size(); ++i) {
        EXPECT_LE(std::abs(raised[i].x), 1e9);
        // Elevation keeps the linear function i.
        EXPECT_NEAR(raised[i].y, 200.0 * static_cast<double>(i) / 10200, 1e-11);
    }
}

RC_GTEST_PROP(Elevate, keepsRepeatedEndsBitForBit, ()) {
    Points curve = *test::anyCurve(3, 8);
    curve[1] = curve.front();
    curve[curve.size() - 2] = curve.back();
    const int times = *rc::gen::inRange(1, 20);
    const Points raised = elevated(curve, times);
    RC_ASSERT(raised[1] == curve.front());
    RC_ASSERT(distance(raised[raised.size() - 2], curve.back()) <= 1e-12);
    const Vector start = curve.front() - Point{};
    for (Point& p : curve)
        p = p - start;
    const Points local = elevated(curve, times);
    RC_ASSERT(local[local.size() - 2] == local.back());
}

RC_GTEST_PROP(Elevate, onceMoreEqualsTwiceOnce, ()) {
    const Points curve = *test::anyCurve(1, 12);
    const Points twice = elevated(elevated(curve, 1), 1);
    const Points atOnce = elevated(curve, 2);
    for (std::size_t i = 0; i < atOnce.size(); ++i)
        RC_ASSERT(distance(twice[i], atOnce[i]) <= 1e-12 * 1000);
}

RC_GTEST_PROP(Elevate, keepsTheCurve, ()) {
    const Points curve = *test::anyCurve(0, 12);
    const double t = *test::anyParameter();
    const int times = *rc::gen::inRange(0, 60);
    RC_ASSERT(distance(evaluate(curve, t), evaluate(elevated(curve, times), t)) <= 1e-12 * 1000);
}

/// Point k of a line, parabola or cubic raised to degree N, from the end to which it is nearer.
Vector fromItsEnd(const std::vector<Vector>& v, double N, double k) {
    const double r = N - k;
    if (v.size() == 2)
        return k * v[1] / N;
    if (v.size() == 3)
        return (2 * k * r * v[1] + k * (k - 1) * v[2]) / (N * (N - 1));
    return (3 * k * r * (r - 1) * v[1] + 3 * k * r * (k - 1) * v[2] + k * (k - 1) * (k - 2) * v[3]) /
           (N * (N - 1) * (N - 2));
}

RC_GTEST_PROP(Elevate, givesOfShortCurvesTheMeansOfTheFormulaToTheLastBit, ()) {
    const Points curve = *test::anyCurve(1, 3);
    const int times = *rc::gen::inRange(2, 40);
    const Points raised = elevated(curve, times);
    const std::size_t N = raised.size() - 1;
    std::vector<Vector> fromStart, fromEnd;
    const Vector end = curve.back() - curve.front();
    for (const Point p : curve) {
        fromStart.push_back(p - curve.front());
        fromEnd.insert(fromEnd.begin(), p - curve.front() - end);
    }
    const auto degree = static_cast<double>(N);
    for (std::size_t i = 1; i < N; ++i) {
        const Vector mean = i <= N / 2 ? fromItsEnd(fromStart, degree, static_cast<double>(i))
                                       : end + fromItsEnd(fromEnd, degree, static_cast<double>(N - i));
        RC_ASSERT(raised[i] == curve.front() + mean);
    }
}

RC_GTEST_PROP(Elevate, staysWithinFourRoundingsOfTheExactMean, ()) {
    const Points curve = *test::anyCurve(1, 3);
    const int times = *rc::gen::element(1, 2, 3, 97, 998, 9998);
    const Points raised = elevated(curve, times);
    const double bound = 4 * 0x1p-52 * 4000;
    const std::size_t n = curve.size() - 1, N = raised.size() - 1;
    for (std::size_t i = 0; i <= N; i += 1 + N / 50) {
        long double x = 0, y = 0;
        for (std::size_t j = 0; j <= n; ++j) {
            long double weight = 1;             // C(n, j) C(N - n, i - j) / C(N, i)
            for (std::size_t k = 0; k < n; ++k) // i places are taken by j, N - i by n - j of the n
                weight *=
                    static_cast<long double>(k < j ? i - std::min(i, k) : N - i - std::min(N - i, k - j)) / (N - k);
            const int choices[4][4] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
            x += choices[n][j] * weight * curve[j].x;
            y += choices[n][j] * weight * curve[j].y;
        }
        RC_ASSERT(std::abs(x - raised[i].x) <= bound);
        RC_ASSERT(std::abs(y - raised[i].y) <= bound);
    }
}

RC_GTEST_PROP(Elevate, intoAnArrayGivesTheSame, ()) {
    const Points curve = *test::anyCurve(0, 8);
    const int times = *rc::gen::inRange(0, 20);
    Points raised(curve.size() + static_cast<std::size_t>(times), Point{1, 1});
    elevate(curve, raised);
    RC_ASSERT(raised == elevated(curve, times));
}

RC_GTEST_PROP(Elevate, runsBackwardsOnReversedPoints, ()) {
    const Points curve = *test::anyCurve(1, 6);
    const int times = *rc::gen::inRange(1, 20);
    const Points raised = elevated(curve, times);
    const Points backwards = elevated(Points(curve.rbegin(), curve.rend()), times);
    for (std::size_t i = 0; i < raised.size(); ++i)
        RC_ASSERT(distance(raised[i], backwards[raised.size() - 1 - i]) <= 1e-12 * 4000);
}

RC_GTEST_PROP(Elevate, losesNothingFarFromTheOrigin, ()) {
    const Points curve = *test::anyCurve(1, 12);
    Points far = curve;
    for (Point& p : far)
        p = p + Vector{1e9, -1e9};
    const Points raised = elevated(curve, 20);
    const Points farRaised = elevated(far, 20);
    for (std::size_t i = 0; i < raised.size(); ++i)
        RC_ASSERT(distance(raised[i] + Vector{1e9, -1e9}, farRaised[i]) <= 2e-7);
}

TEST(ElevationGap, isTheLargestDistanceToTheCurve) {
    const Points curve{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    const Points polygon = elevated(curve, 5);
    double largest = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        largest = std::max(largest, distance(polygon[i], evaluate(curve, static_cast<double>(i) / 8)));
    EXPECT_NEAR(elevationGap(curve, 5), largest, 1e-15);
}

TEST(ElevationGap, fallsLikeOneOverTheDegree) {
    const Points curve{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    EXPECT_NEAR(elevationGap(curve, 4000) * 4003, elevationGap(curve, 8000) * 8003, 1e-3);
}

TEST(ElevationGap, isZeroOnLinesRunThroughEvenly) {
    EXPECT_EQ(elevationGap(Points{{1, 1}, {4, 7}}, 7), 0);
    EXPECT_EQ(elevationGap(Points{{0, 0}, {1, 2}, {2, 4}, {3, 6}}, 100), 0);
}

TEST(ElevationGap, isTheSameFarFromTheOrigin) {
    const Points curve{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    Points far = curve;
    for (Point& p : far)
        p = p + Vector{1e9, 1e9};
    EXPECT_NEAR(elevationGap(far, 10000), elevationGap(curve, 10000), 1e-15);
}

} // namespace
} // namespace kriva
