#include "core/bezier/arc_length.h"
#include "core/bezier/elevate.h"
#include "core/bezier/subdivide.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numbers>

namespace kriva {
namespace {

/// The generator of Steele, Lea, Flood, Fast splittable pseudorandom number generators, OOPSLA 2014.
class SplitMix {
  public:
    explicit SplitMix(std::uint64_t seed)
        : state_(seed) {}

    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
    }
    Vector inSquare(double low, double high) {
        const double x = between(low, high);
        return {x, between(low, high)};
    }

  private:
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

/// Lengths by adaptive Gauss quadrature with 24 points in extended precision, a method that shares nothing with the one
/// under test but Gauss's name.
class Reference {
  public:
    Reference() {
        for (int i = 0; i < kPoints; ++i) {
            Real x = std::cos(std::numbers::pi_v<Real> * (static_cast<Real>(i) + 0.75L) / (kPoints + 0.5L));
            Real slope = 0;
            for (int step = 0; step < 10; ++step) {
                Real before = 1;
                Real value = x;
                for (int k = 2; k <= kPoints; ++k) {
                    const auto m = static_cast<Real>(k);
                    const Real next = ((2 * m - 1) * x * value - (m - 1) * before) / m;
                    before = value;
                    value = next;
                }
                slope = kPoints * (x * value - before) / (x * x - 1);
                x -= value / slope;
            }
            nodes_.push_back({x, 2 / ((1 - x * x) * slope * slope)});
        }
    }

    [[nodiscard]] double length(std::span<const Point> curve) const {
        const auto degree = static_cast<Real>(curve.size() - 1);
        std::vector<Real> x, y;
        Real polygon = 0;
        for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
            x.push_back(degree * (static_cast<Real>(curve[i + 1].x) - static_cast<Real>(curve[i].x)));
            y.push_back(degree * (static_cast<Real>(curve[i + 1].y) - static_cast<Real>(curve[i].y)));
            polygon += std::hypot(x.back(), y.back()) / degree;
        }
        // One pair of rows for all values: this runs a million times.
        std::vector<Real> a = x;
        std::vector<Real> b = y;
        const auto speed = [&](Real t) {
            std::ranges::copy(x, a.begin());
            std::ranges::copy(y, b.begin());
            Real* const rowA = a.data();
            Real* const rowB = b.data();
            for (std::size_t count = x.size(); count > 1; --count)
                for (std::size_t i = 0; i + 1 < count; ++i) {
                    rowA[i] += t * (rowA[i + 1] - rowA[i]);
                    rowB[i] += t * (rowB[i + 1] - rowB[i]);
                }
            return std::sqrt(rowA[0] * rowA[0] + rowB[0] * rowB[0]);
        };
        return static_cast<double>(adaptive(speed, 0, 1, gauss(speed, 0, 1), 1e-17L * polygon, 0));
    }

  private:
    using Real = long double;
    static constexpr int kPoints = 24;
    struct Node {
        Real at;
        Real weight;
    };

    template <class F>
    [[nodiscard]] Real gauss(const F& f, Real from, Real to) const {
        Real sum = 0;
        for (const Node node : nodes_)
            sum += node.weight * f((from + to) / 2 + (to - from) / 2 * node.at);
        return sum * (to - from) / 2;
    }
    template <class F>
    [[nodiscard]] Real adaptive(const F& f, Real from, Real to, Real whole, Real allowed, int depth) const {
        const Real middle = (from + to) / 2;
        const Real left = gauss(f, from, middle);
        const Real right = gauss(f, middle, to);
        if (depth > 45 || std::abs(left + right - whole) < allowed)
            return left + right;
        return adaptive(f, from, middle, left, allowed, depth + 1) + adaptive(f, middle, to, right, allowed, depth + 1);
    }

    std::vector<Node> nodes_;
};

/// A cubic that stands still at a random parameter, its second point then moved by up to 1e-3.
Points nearCusp(SplitMix& random) {
    const double t = random.between(.2, .8);
    const double u = 1 - t;
    const Point start = Point{} + random.inSquare(0, 1000);
    const Vector first = random.inSquare(-300, 300);
    const Vector last = random.inSquare(-300, 300);
    const Vector middle = -(u * u * first + t * t * last) / (2 * t * u);
    Points curve{start, start + first, start + first + middle, start + first + middle + last};
    curve[1] = curve[1] + random.inSquare(-1e-3, 1e-3);
    return curve;
}

constexpr double kPromise = 1e-12;

TEST(ArcLength, ofAThousandCubicsIsRightToTwelveDigits) {
    const Reference reference;
    SplitMix random(42);
    for (int i = 0; i < 1000; ++i) {
        Points curve(4);
        for (Point& p : curve)
            p = Point{} + random.inSquare(0, 1000);
        ASSERT_NEAR(arcLength(curve) / reference.length(curve), 1, kPromise) << i;
    }
}

TEST(ArcLength, ofAThousandNearCuspsIsRightToTwelveDigits) {
    const Reference reference;
    SplitMix random(43);
    for (int i = 0; i < 1000; ++i) {
        const Points curve = nearCusp(random);
        ASSERT_NEAR(arcLength(curve) / reference.length(curve), 1, kPromise) << i;
    }
}

TEST(ArcLength, ofHigherDegreesIsRightToTwelveDigits) {
    const Reference reference;
    SplitMix random(44);
    for (const std::size_t size : {3U, 5U, 6U, 7U, 12U, 31U}) {
        Points curve(size);
        for (Point& p : curve)
            p = Point{} + random.inSquare(0, 1000);
        EXPECT_NEAR(arcLength(curve) / reference.length(curve), 1, kPromise) << size;
    }
}

TEST(ArcLength, ofPointsIsZeroAndOfLinesTheirDistance) {
    EXPECT_EQ(arcLength(Points{{1, 1}}), 0);
    EXPECT_EQ(arcLength(Points(4, Point{0.1, 1e9})), 0);
    EXPECT_EQ(arcLength(Points(201, Point{0.1, 1e9})), 0);
    EXPECT_EQ(arcLength(Points{{0, 0}, {3, 4}}), 5);
    EXPECT_NEAR(arcLength(elevated(Points{{0, 0}, {3, 4}}, 30)) / 5, 1, kPromise);
}

TEST(ArcLength, ofAParabolaHasItsClosedForm) {
    // (t, t^2): sqrt(5) / 2 + asinh(2) / 4.
    EXPECT_NEAR(arcLength(Points{{0, 0}, {0.5, 0}, {1, 1}}), std::sqrt(5.0) / 2 + std::asinh(2.0) / 4, 1e-15);
}

TEST(ArcLength, ofSemicubicalCuspsHasItsClosedForm) {
    // (t^2, t^3): ((4 + 9 t^2)^(3/2) - 8) / 27, with the cusp at the start and, from -1 to 1, in the middle.
    const double half = (std::pow(13.0, 1.5) - 8) / 27;
    EXPECT_NEAR(arcLength(Points{{0, 0}, {0, 0}, {1.0 / 3, 0}, {1, 1}}) / half, 1, kPromise);
    EXPECT_NEAR(arcLength(Points{{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}) / (2 * half), 1, kPromise);
    // Cut elsewhere, so that no halving meets the cusp.
    const Points cut = part(Points{{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}, 0.1, 1);
    const double from = (std::pow(4 + 9 * 0.64, 1.5) - 8) / 27;
    EXPECT_NEAR(arcLength(cut) / (half + from), 1, kPromise);
}

TEST(ArcLength, ofLinesThatTurnBackAddsBothWays) {
    // x = t^2 (3 - 4 t) has its peak 1/4 at 1/2 and ends at -1.
    EXPECT_NEAR(arcLength(Points{{0, 0}, {0, 0}, {1, 0}, {-1, 0}}), 0.25 + 1.25, 1e-12);
    // The same along a slanted line.
    EXPECT_NEAR(arcLength(Points{{0, 0}, {0, 0}, {3, 4}, {-3, -4}}) / 5, 1.5, 1e-12);
    // There and back again: x = 2 t (1 - t).
    EXPECT_NEAR(arcLength(Points{{0, 0}, {1, 0}, {0, 0}}), 1, 1e-12);
    // At degree 6, 60 (t (1 - t))^3 / 64 rises to 60 / 4096 and falls again; it stands still at both ends, too.
    EXPECT_NEAR(arcLength(Points{{0, 0}, {0, 0}, {0, 0}, {3, 0}, {0, 0}, {0, 0}, {0, 0}}) / (2 * 60.0 / 64), 1, 1e-12);
}

TEST(ArcLength, ofPointsRepeatedTenTimes) {
    Points curve(30);
    for (std::size_t i = 0; i < curve.size(); ++i)
        curve[i] = i < 10 ? Point{0, 0} : i < 20 ? Point{1, 2} : Point{3, 0};
    EXPECT_NEAR(arcLength(curve) / Reference().length(curve), 1, kPromise);
}

TEST(ArcLength, changesNoBitFarFromTheOriginOrAtAnotherScale) {
    const Points curve{{0, 0}, {1, 2}, {0.25, 2.5}, {4, 0.125}};
    Points far = curve;
    Points small = curve;
    Points large = curve;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        far[i] = curve[i] + Vector{1048576, -1048576};
        small[i] = {curve[i].x * 0x1p-400, curve[i].y * 0x1p-400};
        large[i] = {curve[i].x * 0x1p+28, curve[i].y * 0x1p+28};
    }
    EXPECT_EQ(arcLength(far), arcLength(curve));
    EXPECT_EQ(arcLength(small), arcLength(curve) * 0x1p-400);
    EXPECT_EQ(arcLength(large), arcLength(curve) * 0x1p+28);
}

RC_GTEST_PROP(ArcLength, liesBetweenChordAndPolygon, ()) {
    const Points curve = *test::anyCurve(1, 12);
    double polygon = 0;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i)
        polygon += distance(curve[i], curve[i + 1]);
    const double length = arcLength(curve);
    RC_ASSERT(length <= polygon * (1 + kPromise));
    RC_ASSERT(length >= distance(curve.front(), curve.back()) * (1 - kPromise));
}

RC_GTEST_PROP(ArcLength, isTheSumOfTheHalves, ()) {
    const Points curve = *test::anyCurve(1, 12);
    const Halves halves = split(curve, *rc::gen::element(0.1, 0.375, 0.5, 0.9));
    const double length = arcLength(curve);
    RC_ASSERT(std::abs(arcLength(halves.left) + arcLength(halves.right) - length) <= 1e-12 * 12000);
}

RC_GTEST_PROP(ArcLength, isTheSameBackwardsAndElevated, ()) {
    const Points curve = *test::anyCurve(1, 12);
    const double length = arcLength(curve);
    RC_ASSERT(std::abs(arcLength(Points(curve.rbegin(), curve.rend())) - length) <= kPromise * length);
    RC_ASSERT(std::abs(arcLength(elevated(curve, 3)) - length) <= 1e-12 * 12000);
}

TEST(ParameterAtLength, clampsToTheEnds) {
    const Points curve{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    EXPECT_EQ(parameterAtLength(curve, -1), 0);
    EXPECT_EQ(parameterAtLength(curve, 0), 0);
    EXPECT_EQ(parameterAtLength(curve, 100), 1);
    EXPECT_EQ(parameterAtLength(Points{{1, 1}}, 1), 0);
    EXPECT_EQ(parameterAtLength(Points(4, Point{1, 1}), 1), 0);
    EXPECT_NEAR(parameterAtLength(Points{{0, 0}, {3, 4}}, 2), 0.4, 1e-15);
}

TEST(ParameterAtLength, findsTheMiddleOfASymmetricCurve) {
    const Points arch{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    EXPECT_NEAR(parameterAtLength(arch, arcLength(arch) / 2), 0.5, 1e-14);
    const Points cusp{{0, 0}, {1, 1}, {0, 1}, {1, 0}};
    // At the cusp the length grows like the square of the parameter: half its digits are lost.
    EXPECT_NEAR(parameterAtLength(cusp, arcLength(cusp) / 2), 0.5, 1e-6);
}

RC_GTEST_PROP(ParameterAtLength, isTheInverseOfTheLength, ()) {
    const Points curve = *test::anyCurve(1, 8);
    const double length = arcLength(curve);
    const double share = *test::anyParameter();
    const Points start = part(curve, 0, parameterAtLength(curve, share * length));
    RC_ASSERT(std::abs(arcLength(start) - share * length) <= 1e-12 * 8000);
}

} // namespace
} // namespace kriva
