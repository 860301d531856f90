#include "ui/canvas/base/grid.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace kriva::ui {
namespace {

RC_GTEST_PROP(Grid, stepsAreOneTwoOrFiveTimesAPowerOfTenAndNeverTooDense, ()) {
    Viewport viewport;
    viewport.scale = std::pow(10, *rc::gen::inRange(-14'000, 17'000) / 1e3);
    const double step = gridStep(viewport);
    const double pixels = step * viewport.scale;
    RC_ASSERT(pixels >= kGridSpacing * (1 - 1e-12));
    RC_ASSERT(pixels <= 2.5 * kGridSpacing * (1 + 1e-12));
    const double mantissa = step / std::pow(10, std::floor(std::log10(step * (1 + 1e-12))));
    RC_ASSERT(std::min({std::abs(mantissa - 1), std::abs(mantissa - 2), std::abs(mantissa - 5)}) < 1e-9);
}

TEST(Grid, multiplesRunFromLowToHighIncludingBoth) {
    EXPECT_EQ(multiples(2, -4, 4), (std::vector<double>{-4, -2, 0, 2, 4}));
    EXPECT_EQ(multiples(5, 1, 4), std::vector<double>());
}

TEST(Grid, multiplesFarFromTheOriginComeToAnEnd) {
    EXPECT_LE(multiples(1e-9, 1e9, 1e9 + 1).size(), 10'000U);
}

} // namespace
} // namespace kriva::ui
