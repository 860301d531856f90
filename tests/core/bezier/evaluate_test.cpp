#include "core/bezier/evaluate.h"
#include "core/geometry/box.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

namespace kriva {
namespace {

const Points kCubic{{0, 0}, {1, 2}, {3, 2}, {4, 0}};

TEST(Evaluate, meetsTheTextbookValuesOfACubic) {
    EXPECT_EQ(evaluate(kCubic, 0.5), (Point{2, 1.5}));
    EXPECT_EQ(derivative(kCubic, 0.5), (Vector{4.5, 0}));
    EXPECT_EQ(secondDerivative(kCubic, 0.5), (Vector{0, -12}));
}

TEST(Evaluate, aSinglePointStandsStill) {
    const Points point{{0.1, 0.2}};
    EXPECT_EQ(evaluate(point, 0.3), point[0]);
    EXPECT_EQ(derivative(point, 0.3), (Vector{0, 0}));
    EXPECT_EQ(secondDerivative(point, 0.3), (Vector{0, 0}));
    EXPECT_TRUE(hodograph(point).empty());
}

TEST(Evaluate, aLineHasNoSecondDerivative) {
    const Points line{{1, 1}, {4, 5}};
    EXPECT_EQ(secondDerivative(line, 0.3), (Vector{0, 0}));
    EXPECT_EQ(derivative(line, 0.3), (Vector{3, 4}));
}

TEST(Evaluate, repeatedPointsGiveThatPointBitForBit) {
    const Points same(201, Point{0.1, 1e9});
    for (const double t : {0.1, 0.3, 0.7})
        EXPECT_EQ(evaluate(same, t), same[0]);
}

TEST(Evaluate, losesNothingFarFromTheOriginAtDegree200) {
    Points near(201);
    Points far(201);
    for (std::size_t i = 0; i < near.size(); ++i) {
        near[i] = {static_cast<double>(i % 7), static_cast<double>(i % 5)};
        far[i] = near[i] + Vector{1e9, 1e9};
    }
    for (const double t : {0.1, 0.3, 0.7})
        EXPECT_LE(distance(evaluate(near, t) + Vector{1e9, 1e9}, evaluate(far, t)), 2e-7);
}

RC_GTEST_PROP(Evaluate, meetsTheEndsExactly, ()) {
    const Points curve = *test::anyCurve(0, 30);
    RC_ASSERT(evaluate(curve, 0) == curve.front());
    RC_ASSERT(evaluate(curve, 1) == curve.back());
}

RC_GTEST_PROP(Evaluate, staysInTheBoxOfTheControlPoints, ()) {
    const Points curve = *test::anyCurve(0, 30);
    const Point p = evaluate(curve, *test::anyParameter());
    RC_ASSERT(overlap(boxOf(Points{p}), grown(boxOf(curve), 1e-12 * 1000)));
}

RC_GTEST_PROP(Evaluate, runsBackwardsOnReversedPoints, ()) {
    const Points curve = *test::anyCurve(0, 30);
    const Points reversed(curve.rbegin(), curve.rend());
    const double t = *test::anyParameter();
    RC_ASSERT(distance(evaluate(curve, t), evaluate(reversed, 1 - t)) <= 1e-12 * 1000);
}

RC_GTEST_PROP(Evaluate, followsAffineMaps, ()) {
    const auto map = [](Point p) { return Point{0.5 * p.x - 2 * p.y + 7, 0.25 * p.x + 3 * p.y - 1}; };
    const Points curve = *test::anyCurve(0, 20);
    Points mapped;
    for (const Point p : curve)
        mapped.push_back(map(p));
    const double t = *test::anyParameter();
    RC_ASSERT(distance(map(evaluate(curve, t)), evaluate(mapped, t)) <= 1e-12 * 5000);
}

RC_GTEST_PROP(Evaluate, isTheSumOfControlPointsAndBernsteinPolynomials, ()) {
    const Points curve = *test::anyCurve(0, 20);
    const double t = *test::anyParameter();
    const std::vector<double> weights = bernstein(static_cast<int>(curve.size()) - 1, t);
    Vector sum;
    for (std::size_t i = 0; i < curve.size(); ++i)
        sum = sum + weights[i] * (curve[i] - Point{0, 0});
    RC_ASSERT(length(sum - (evaluate(curve, t) - Point{0, 0})) <= 1e-12 * 1000);
}

RC_GTEST_PROP(Derivative, startsAndEndsAlongTheControlPolygon, ()) {
    const Points curve = *test::anyCurve(1, 20);
    const auto degree = static_cast<double>(curve.size() - 1);
    RC_ASSERT(derivative(curve, 0) == degree * (curve[1] - curve[0]));
    RC_ASSERT(derivative(curve, 1) == degree * (curve.back() - curve[curve.size() - 2]));
}

RC_GTEST_PROP(Derivative, isTheCurveOfTheHodograph, ()) {
    const Points curve = *test::anyCurve(1, 20);
    Points velocities;
    for (const Vector v : hodograph(curve))
        velocities.push_back(Point{0, 0} + v);
    const double t = *test::anyParameter();
    RC_ASSERT(length(derivative(curve, t) - (evaluate(velocities, t) - Point{0, 0})) <= 1e-12 * 40000);
    RC_ASSERT(length(secondDerivative(curve, t) - derivative(velocities, t)) <= 1e-12 * 1600000);
}

std::vector<Point> manyOf(const Points& curve, const std::vector<double>& ts) {
    std::vector<Point> points(ts.size());
    evaluate(curve, ts, points);
    return points;
}

rc::Gen<std::vector<double>> anyParameters() {
    return rc::gen::container<std::vector<double>>(test::anyParameter());
}

/// De Casteljau's scheme with more digits.
Point exactly(const Points& curve, double t) {
    std::vector<long double> x, y;
    for (const Point p : curve) {
        x.push_back(static_cast<long double>(p.x) - curve[0].x);
        y.push_back(static_cast<long double>(p.y) - curve[0].y);
    }
    for (std::size_t count = curve.size() - 1; count > 0; --count)
        for (std::size_t i = 0; i < count; ++i) {
            x[i] = (1 - static_cast<long double>(t)) * x[i] + t * x[i + 1];
            y[i] = (1 - static_cast<long double>(t)) * y[i] + t * y[i + 1];
        }
    return {static_cast<double>(curve[0].x + x[0]), static_cast<double>(curve[0].y + y[0])};
}

RC_GTEST_PROP(EvaluateMany, givesUpToDegreeFiveWhatEachParameterGivesAlone, ()) {
    const Points curve = *test::anyCurve(0, 5);
    const std::vector<double> ts = *anyParameters();
    const std::vector<Point> points = manyOf(curve, ts);
    for (std::size_t i = 0; i < ts.size(); ++i)
        RC_ASSERT(points[i] == evaluate(curve, ts[i]));
}

RC_GTEST_PROP(EvaluateMany, staysWithinItsRoundingsAboveDegreeFive, ()) {
    const Points curve = *rc::gen::mapcat(rc::gen::element<std::size_t>(7, 8, 12, 31, 101, 201), [](std::size_t size) {
        return rc::gen::container<Points>(size, test::anyPoint());
    });
    const std::vector<double> ts = *anyParameters();
    const double size = diagonal(boxOf(curve));
    const double bound = 4 * static_cast<double>(curve.size()) * 0x1p-53 * size + 0x1p-52 * 1000;
    const std::vector<Point> points = manyOf(curve, ts);
    for (std::size_t i = 0; i < ts.size(); ++i)
        RC_ASSERT(distance(points[i], exactly(curve, ts[i])) <= bound);
}

TEST(EvaluateMany, meetsEndsAndRepeatedPointsBitForBit) {
    for (const std::size_t size : {1U, 2U, 4U, 7U, 201U, 2001U}) {
        Points curve(size, Point{0.1, 1e9});
        for (const Point p : manyOf(curve, {0, 0.1, 0.3, 0.7, 1}))
            EXPECT_EQ(p, curve[0]);
        curve.front() = {-0.0, 0.3};
        curve.back() = {1e-9, -7};
        const std::vector<Point> ends = manyOf(curve, {0.2, 1, 0, 0.5, 0, 1});
        EXPECT_EQ(ends[1], curve.back());
        EXPECT_EQ(ends[2], curve.front());
        EXPECT_EQ(std::signbit(ends[2].x), std::signbit(curve.front().x));
        EXPECT_EQ(ends[4], curve.front());
        EXPECT_EQ(ends[5], curve.back());
    }
    EXPECT_TRUE(manyOf({{1, 2}, {3, 4}}, {}).empty());
}

TEST(EvaluateMany, losesNothingFarFromTheOriginAndAtTheHighestCoordinates) {
    Points curve(201);
    for (std::size_t i = 0; i < curve.size(); ++i)
        curve[i] = {i % 2 == 0 ? 1e9 : -1e9, 1e9 + static_cast<double>(i)};
    for (const double t : {0.01, 0.5, 0.99}) {
        const Point p = manyOf(curve, {t})[0];
        EXPECT_NEAR(p.x, exactly(curve, t).x, 4e-5);
        EXPECT_NEAR(p.y, 1e9 + 200 * t, 2e-7);
    }
}

TEST(Bernstein, areNonNegativeAndSumToOne) {
    for (const int degree : {0, 1, 5, 200})
        for (const double t : {0.0, 0.1, 0.5, 0.9, 1.0}) {
            const std::vector<double> values = bernstein(degree, t);
            ASSERT_EQ(values.size(), static_cast<std::size_t>(degree) + 1);
            EXPECT_NEAR(std::accumulate(values.begin(), values.end(), 0.0), 1, 1e-13);
            for (const double value : values)
                EXPECT_GE(value, 0);
        }
}

RC_GTEST_PROP(Bernstein, haveTheirClosedForm, ()) {
    const int degree = *rc::gen::inRange(0, 40);
    const double t = *test::anyParameter();
    const std::vector<double> values = bernstein(degree, t);
    const std::vector<double> mirrored = bernstein(degree, 1 - t);
    double binomial = 1;
    for (int i = 0; i <= degree; ++i) {
        const auto at = static_cast<std::size_t>(i);
        RC_ASSERT(std::abs(values[at] - binomial * std::pow(t, i) * std::pow(1 - t, degree - i)) <= 1e-14);
        RC_ASSERT(std::abs(values[at] - mirrored[values.size() - 1 - at]) <= 1e-14);
        binomial *= static_cast<double>(degree - i) / (i + 1);
    }
}

} // namespace
} // namespace kriva
