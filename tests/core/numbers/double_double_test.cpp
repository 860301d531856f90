#include "core/numbers/double_double_lanes.h"
#include "tests/core/polynomial/any_number.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

namespace kriva {
namespace {

RC_GTEST_PROP(DoubleDouble, keepsWhatASumOfTwoDoublesRoundsOff, ()) {
    const double a = anyNumber(-20, 20);
    const double b = anyNumber(-20, 20);
    const DoubleDouble sum = exactSum(a, b);
    RC_ASSERT(sum.high == a + b);
    RC_ASSERT(sum - a == DoubleDouble(b));
}

RC_GTEST_PROP(DoubleDouble, dividesBackToTheFactor, ()) {
    const DoubleDouble a = exactSum(anyNumber(-20, 20), anyNumber(-20, 20) * 0x1p-50);
    const DoubleDouble b = exactSum(anyNumber(-20, 20), anyNumber(-20, 20) * 0x1p-50);
    RC_ASSERT(abs(a * b / b - a).high <= 0x1p-100 * abs(a).high);
    RC_ASSERT(abs((a + b) - b - a).high <= 0x1p-100 * (abs(a).high + abs(b).high));
}

RC_GTEST_PROP(DoubleDouble, squareOfTheRootIsTheNumber, ()) {
    const DoubleDouble a = abs(exactSum(anyNumber(-20, 20), anyNumber(-20, 20) * 0x1p-50));
    RC_ASSERT(abs(sqrt(a) * sqrt(a) - a).high <= 0x1p-100 * a.high);
}

RC_GTEST_PROP(DoubleDouble, isTheSameInLanesAsAlone, ()) {
    using Numbers = std::array<double, DoubleDoubleLanes::kCount>;
    const auto anyLanes = [] {
        Numbers high;
        Numbers low;
        for (std::size_t i = 0; i < high.size(); ++i) {
            const DoubleDouble number = exactSum(anyNumber(-20, 20), anyNumber(-20, 20) * 0x1p-50);
            high[i] = number.high;
            low[i] = number.low;
        }
        return DoubleDoubleLanes::at(high.data(), low.data());
    };
    const DoubleDoubleLanes a = anyLanes();
    const DoubleDoubleLanes b = anyLanes();
    const DoubleDoubleLanes sum = a + b;
    const DoubleDoubleLanes product = a * b;
    for (std::size_t i = 0; i < DoubleDoubleLanes::kCount; ++i) {
        RC_ASSERT(sum[i] == a[i] + b[i]);
        RC_ASSERT(product[i] == a[i] * b[i]);
    }
}

TEST(DoubleDouble, hasNoRootButZeroOfZero) {
    EXPECT_EQ(sqrt(DoubleDouble(0)), DoubleDouble(0));
}

} // namespace
} // namespace kriva
