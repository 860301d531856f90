#include "core/numbers/double_double.h"
#include "tests/core/polynomial/any_number.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

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

TEST(DoubleDouble, hasNoRootButZeroOfZero) {
    EXPECT_EQ(sqrt(DoubleDouble(0)), DoubleDouble(0));
}

} // namespace
} // namespace kriva
