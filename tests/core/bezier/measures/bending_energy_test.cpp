#include "core/bezier/elevate.h"
#include "core/bezier/measures/bending_energy.h"
#include "core/bezier/measures/curvature.h"
#include "core/bezier/subdivide.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

/// The energy of (t, t^2), 0 <= t <= b: the integral of 4 (1 + 4 t^2)^(-5/2), with t = sinh(u) / 2 or tan(v) / 2 equal
/// to 2 (sin v - sin^3 v / 3).
double parabolaEnergy(double b) {
    const double sine = 2 * b / std::sqrt(1 + 4 * b * b);
    return 2 * (sine - sine * sine * sine / 3);
}

Points parabola(double b) {
    return {{0, 0}, {b / 2, 0}, {b, b * b}};
}

TEST(BendingEnergy, ofParabolas) {
    for (const double b : {0.01, 1.0, 1e3})
        EXPECT_NEAR(bendingEnergy(parabola(b)).value() / parabolaEnergy(b), 1, 1e-11);
    // From far away the vertex is nearly a cusp.
    const double b = 1e6;
    EXPECT_NEAR(bendingEnergy(Points{{-b, b * b}, {0, -b * b}, {b, b * b}}).value() / (2 * parabolaEnergy(b)), 1,
                1e-10);
}

TEST(BendingEnergy, ofStraightCurvesIsZero) {
    EXPECT_EQ(bendingEnergy(Points{{1, 1}}), 0.0);
    EXPECT_EQ(bendingEnergy(Points(4, Point{1, 1})), 0.0);
    EXPECT_EQ(bendingEnergy(Points{{0, 0}, {5, 5}}), 0.0);
    EXPECT_EQ(bendingEnergy(Points{{0, 0}, {2, 2}, {-1, -1}, {1, 1}}), 0.0);
}

TEST(BendingEnergy, divergesWhereTheCurveStandsStill) {
    EXPECT_FALSE(bendingEnergy(Points{{0, 0}, {1, 1}, {0, 1}, {1, 0}}));
    EXPECT_FALSE(bendingEnergy(Points{{0, 0}, {0, 0}, {1, 0}, {1, 1}}));
    EXPECT_FALSE(bendingEnergy(Points{{0, 0}, {1, 0}, {1, 1}, {1, 1}}));
}

TEST(BendingEnergy, isFiniteJustAboveStandstill) {
    // Blunting the cusp by h leaves the speed 3 h / 4 at the middle, of a polygon of length 1 + 2 sqrt(2).
    EXPECT_TRUE(bendingEnergy(Points{{0, 0}, {1 - 6e-9, 1}, {0, 1}, {1, 0}}));
    EXPECT_FALSE(bendingEnergy(Points{{0, 0}, {1 - 4e-9, 1}, {0, 1}, {1, 0}}));
}

TEST(BendingEnergy, ofANearlyStraightCurveKeepsItsDigits) {
    // (t, h t (1 - t)), with curvature 2 h up to h^3.
    const double h = 1e-8;
    EXPECT_NEAR(bendingEnergy(Points{{0, 0}, {0.5, h / 2}, {1, 0}}).value() / (4 * h * h), 1, 1e-12);
    // Far from the origin too, where control points are multiples of 2^-23: here h is 1e-6, the scale 2 width.
    const double step = 0x1p-23;
    const double width = 1e6 * step;
    const Points far{{1e9, 1e9}, {1e9 + width, 1e9 + step}, {1e9 + 2 * width, 1e9}};
    EXPECT_NEAR(bendingEnergy(far).value() * width / 2e-12, 1, 1e-11);
}

RC_GTEST_PROP(BendingEnergy, isTheSumOfTheHalves, ()) {
    const Points curve = *test::anyCurve(2, 6);
    const Halves halves = split(curve, 0.375);
    const auto whole = bendingEnergy(curve);
    const auto left = bendingEnergy(halves.left);
    const auto right = bendingEnergy(halves.right);
    RC_PRE(!isStraight(halves.left) && !isStraight(halves.right) && whole && left && right);
    // Splitting rounds; where the curve nearly stands still this alone moves the energy.
    RC_PRE(*whole < 1e3);
    RC_ASSERT(std::abs(*left + *right - *whole) <= 1e-9 * *whole);
}

RC_GTEST_PROP(BendingEnergy, shrinksAsTheCurveGrows, ()) {
    const Points curve = *test::anyCurve(2, 6);
    Points doubled = curve;
    for (Point& p : doubled)
        p = {2 * p.x, 2 * p.y};
    const auto before = bendingEnergy(curve);
    const auto after = bendingEnergy(doubled);
    RC_ASSERT(before.has_value() == after.has_value());
    RC_ASSERT(!before || *before == 2 * *after);
}

RC_GTEST_PROP(BendingEnergy, isTheSameBackwards, ()) {
    const Points curve = *test::anyCurve(2, 6);
    const auto forwards = bendingEnergy(curve);
    const auto backwards = bendingEnergy(Points(curve.rbegin(), curve.rend()));
    RC_ASSERT(forwards.has_value() == backwards.has_value());
    RC_ASSERT(!forwards || std::abs(*forwards - *backwards) <= 1e-10 * *forwards);
}

TEST(BendingEnergy, survivesElevationToDegree40) {
    const Points curve{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    EXPECT_NEAR(bendingEnergy(elevated(curve, 37)).value() / bendingEnergy(curve).value(), 1, 1e-10);
}

} // namespace
} // namespace kriva
