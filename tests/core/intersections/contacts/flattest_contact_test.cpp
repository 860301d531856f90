#include "core/intersections/contacts/flattest_contact.h"
#include "tests/core/intersections/arcs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

using test::plainArc;

/// (u, u^k - depth) of degree max(k, 1), u from -1 to 1.
Arc powerArc(std::size_t k, double depth = 0) {
    Points points;
    for (std::size_t i = 0; i <= k; ++i) { // the coefficients of u^k are -1 or 1 by turns
        const double x = 2 * static_cast<double>(i) / static_cast<double>(k) - 1;
        points.push_back({x, ((k - i) % 2 == 0 ? 1 : -1) - depth});
    }
    return plainArc(points);
}

/// Along the x axis, with u = 0 at its parameter 0.4.
const Arc kAxis = plainArc(Points{{-2, 0}, {3, 0}});

TEST(FlattestContact, isTheRootOfAnyOrder) {
    for (std::size_t k = 1; k <= 5; ++k)
        for (const double away : {-0.01, -1e-4, 0.0, 1e-5, 0.003, 0.02}) {
            const Contact near{0.5 + away, 0.4 + away / 2};
            const Contact found = flattestContact(powerArc(k), kAxis, near, 0.08);
            // Flatter than rounding nobody sees a difference.
            const double allowed = std::max(1e-9, std::pow(1e-15, 1 / static_cast<double>(k)));
            EXPECT_NEAR(found.a, 0.5, allowed) << k << ' ' << away;
            EXPECT_NEAR(found.b, 0.4, allowed) << k << ' ' << away;
        }
}

TEST(FlattestContact, isSeenFromTheOtherArcToo) {
    for (std::size_t k = 1; k <= 3; ++k) {
        const Contact found = flattestContact(kAxis, powerArc(k), {0.4 + 1e-3, 0.5}, 0.01);
        EXPECT_NEAR(found.a, 0.4, 1e-9) << k;
        EXPECT_NEAR(found.b, 0.5, 1e-9) << k;
    }
}

TEST(FlattestContact, isWhereArcsAreNearestThatDoNotQuiteTouch) {
    EXPECT_NEAR(flattestContact(powerArc(2, -1e-12), kAxis, {0.5 + 1e-6, 0.4}, 1e-3).a, 0.5, 1e-9);
}

TEST(FlattestContact, isTheRootItselfSeenClosely) {
    // u^2 = 1e-12: the roots are 1e-6 from 0, half of that in the parameter.
    const double root = 0.5e-6;
    EXPECT_NEAR(flattestContact(powerArc(2, 1e-12), kAxis, {0.5 + 1.1 * root, 0.4}, root / 2).a, 0.5 + root,
                root / 1e3);
}

TEST(FlattestContact, ofCurvesThatRunTheOtherWayIsTheSame) {
    const Arc back = reversed(kAxis); // its own parameters are mirrored
    const Contact found = flattestContact(powerArc(2), back, {0.501, 0.6}, 0.01);
    EXPECT_NEAR(found.a, 0.5, 1e-9);
    EXPECT_NEAR(found.b, 0.6, 1e-9);
}

TEST(FlattestContact, staysWithinTheArcs) {
    // The root lies before the start of the right half.
    const Arc right = part(powerArc(2), 0.5 + 0x1p-20, 1);
    const Contact found = flattestContact(right, kAxis, {1e-4, 0.4}, 1);
    EXPECT_GE(found.a, 0);
    EXPECT_LE(found.a, 1);
    EXPECT_GE(found.b, 0);
    EXPECT_LE(found.b, 1);
}

TEST(FlattestContact, staysNearWhereNothingTellsMore) {
    const Arc still = plainArc(Points(4, Point{0, 0}));
    EXPECT_EQ(flattestContact(still, kAxis, {0.25, 0.4}, 0.1).a, 0.25);
    const Arc line = plainArc(Points{{-1, 0}, {1, 0}});
    EXPECT_EQ(flattestContact(line, kAxis, {0.25, 0.3}, 0.1).a, 0.25) << "one line";
}

RC_GTEST_PROP(FlattestContact, isNeverFartherApartThanTheContactNearIt, ()) {
    const Arc a = *test::anyArc(), b = *test::anyArc();
    const Contact near{*test::anyParameter(), *test::anyParameter()};
    const Contact found = flattestContact(a, b, near, *rc::gen::elementOf(std::vector{1e-6, 1e-3, 1.0}));
    RC_ASSERT(found.a >= 0 && found.a <= 1 && found.b >= 0 && found.b <= 1);
    RC_ASSERT(gapAt(a, b, found) <= gapAt(a, b, near) + 1e-15 || near.b != found.b);
}

} // namespace
} // namespace kriva
