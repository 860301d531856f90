#include "core/bezier/elevate.h"
#include "core/bezier/measures/arc_length.h"
#include "core/bezier/measures/speed_integral.h"
#include "tests/support/data_sets.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

using test::SplitMix;

constexpr double kPromisedError = 1e-12;

Point anywhere(SplitMix& random) {
    return Point{} + random.inSquare(-1000, 1000);
}

Points anyCubic(SplitMix& random) {
    return {anywhere(random), anywhere(random), anywhere(random), anywhere(random)};
}

Points anyParabola(SplitMix& random) {
    return {anywhere(random), anywhere(random), anywhere(random)};
}

/// A cubic that stands still at some parameter, its second point then moved by at most 1e-14 to 100.
Points anyCusp(SplitMix& random) {
    const double t = random.between(.01, .99);
    const double u = 1 - t;
    const Vector first = random.inSquare(-300, 300);
    const Vector last = random.inSquare(-300, 300);
    const Vector middle = -(u * u * first + t * t * last) / (2 * t * u);
    const double off = std::pow(10, random.between(-14, 2));
    const Point third = Point{} + first + middle;
    return {{}, Point{} + first + random.inSquare(-off, off), third, third + last};
}

/// All on one line, where the curve may turn back twice.
Points anyLine(SplitMix& random) {
    Points points;
    for (int i = 0; i < 4; ++i) {
        const double at = std::floor(random.between(-10, 10));
        points.push_back({3 * at, -4 * at});
    }
    return points;
}

/// One handle or both nearly in their knots.
Points anyShortHandle(SplitMix& random) {
    const Point end = anywhere(random);
    const double size = std::pow(10, random.between(-16, 1));
    return {{}, Point{} + random.inSquare(-size, size), end + random.inSquare(-size, size), end};
}

TEST(SpeedIntegral, isWhatHalvingTellsOfTenThousandCurvesOfEachKind) {
    for (const auto& any : {anyCubic, anyParabola, anyCusp, anyLine, anyShortHandle}) {
        SplitMix random(50);
        int over = 0;
        for (int i = 0; i < 10'000; ++i) {
            const Points curve = any(random);
            // Raised above degree 3, the same curve is measured by halving it alone.
            const double halved = arcLength(elevated(curve, curve.size() == 3 ? 2 : 1));
            over += !(std::abs(arcLength(curve) - halved) <= kPromisedError * halved);
        }
        EXPECT_EQ(over, 0);
    }
}

TEST(SpeedIntegral, ofConstantsAndSquaresIsExact) {
    EXPECT_EQ(integralOfSpeed({{3, 4}, {}, {}}), 5);
    EXPECT_EQ(integralOfSpeed({{}, {}, {-9, 12}}), 5);
    EXPECT_EQ(integralOfSpeed({}), 0);
    EXPECT_NEAR(integralOfSpeed({{}, {6, 8}, {}}), 5, 1e-15 * 5);
}

TEST(SpeedIntegral, passesAStandstillInsideAndAtTheEnds) {
    // (t - a)^2 + b^2 along x, with zeros at a + ib: 1/3 - a + a^2 + b^2.
    for (const double a : {0.0, 1e-9, 0.3, 0.5, 1 - 1e-9, 1.0})
        for (const double b : {0.0, 1e-12, 1e-6, 0.01, 0.1}) {
            const double expected = 1.0 / 3 - a + a * a + b * b;
            EXPECT_NEAR(integralOfSpeed({{a * a + b * b, 0}, {-2 * a, 0}, {1, 0}}) / expected, 1, kPromisedError);
        }
    // t - a along x and b along y: one zero at a + ib.
    const auto primitive = [](double s, double b) {
        return b == 0 ? s * std::abs(s) / 2 : (s * std::hypot(s, b) + b * b * std::asinh(s / b)) / 2;
    };
    for (const double a : {0.0, 1e-9, 0.3, 0.5, 1.0})
        for (const double b : {0.0, 1e-12, 1e-6, 0.01, 0.1}) {
            const double expected = primitive(1 - a, b) - primitive(-a, b);
            EXPECT_NEAR(integralOfSpeed({{-a, b}, {1, 0}, {}}) / expected, 1, kPromisedError);
        }
}

TEST(SpeedIntegral, knowsTwoStandstills) {
    // (t - 1/4) (t - 3/4) along x: 1/48 on each side of each.
    EXPECT_NEAR(integralOfSpeed({{3.0 / 16, 0}, {-1, 0}, {1, 0}}) * 16, 1, kPromisedError);
    EXPECT_NEAR(integralOfSpeed({{0, 3.0 / 16}, {0, -1}, {0, 1}}) * 16, 1, kPromisedError);
}

} // namespace
} // namespace kriva
