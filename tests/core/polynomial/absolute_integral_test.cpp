#include "core/polynomial/absolute_integral.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace kriva {
namespace {

TEST(AbsoluteIntegral, isTheIntegralWhereTheSignStays) {
    EXPECT_DOUBLE_EQ(absoluteIntegral({{{1, 2, 3}, 2}}), 4);
    EXPECT_DOUBLE_EQ(absoluteIntegral({{{-1, -2, -3}, 2}, {{5}, 1}}), 9);
    EXPECT_EQ(absoluteIntegral({}), 0);
    EXPECT_EQ(absoluteIntegral({{{0, 0}, 1}}), 0);
}

TEST(AbsoluteIntegral, splitsAtRoots) {
    // |3t - 1| over [0, 1]: triangles of 1/3 * 1 / 2 and 2/3 * 2 / 2.
    EXPECT_NEAR(absoluteIntegral({{{-1, 2}, 1}}), 5.0 / 6, 1e-11);
    // |t (1 - t) - 3/16|, roots 1/4 and 3/4: twice the integral from 1/4 to 3/4 (1/48) minus that of the whole (-1/48).
    EXPECT_NEAR(absoluteIntegral({{{-3.0 / 16, 5.0 / 16, -3.0 / 16}, 1}}), 1.0 / 16, 1e-12);
}

TEST(AbsoluteIntegral, seesRootsOfHighMultiplicity) {
    // |u|^5 for u = 2t - 1 over [0, 1]: 1/6.
    EXPECT_NEAR(absoluteIntegral({{{-1, 1, -1, 1, -1, 1}, 1}}), 1.0 / 6, 1e-11);
}

TEST(AbsoluteIntegral, isNotFiniteWhereACoefficientIsNot) {
    EXPECT_FALSE(std::isfinite(absoluteIntegral({{{-1, std::numeric_limits<double>::infinity()}, 1}})));
}

} // namespace
} // namespace kriva
