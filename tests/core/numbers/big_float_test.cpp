#include "core/numbers/big_float.h"
#include "tests/core/polynomial/any_number.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace kriva {
namespace {

constexpr int kDigits = 8;

BigFloat big(double value) {
    return {value, kDigits};
}

RC_GTEST_PROP(BigFloat, givesDoublesBackBitForBit, ()) {
    const double a = anyNumber(-300, 300);
    RC_ASSERT(big(a).toDouble() == a);
    RC_ASSERT((-big(a)).toDouble() == -a);
}

RC_GTEST_PROP(BigFloat, addsAndMultipliesAsDoublesDoButRoundsOnce, ()) {
    const double a = anyNumber(-300, 300);
    const double b = anyNumber(-300, 300);
    // A sum or product of two doubles, cut off after 8 digits and rounded, is the correctly rounded one.
    RC_ASSERT((big(a) + big(b)).toDouble() == a + b);
    RC_ASSERT((big(a) - big(b)).toDouble() == a - b);
    RC_ASSERT((big(a) * big(b)).toDouble() == a * b);
}

RC_GTEST_PROP(BigFloat, takesBackWhatWasAdded, ()) {
    const double small = std::ldexp(anyNumber(-300, 300), -40);
    const double large = std::ldexp(1 + *rc::gen::inRange(0, 1000), *rc::gen::inRange(-300, 60));
    const BigFloat sum = big(small) + big(large);
    RC_PRE(std::abs(small) > std::abs(large) * 0x1p-350);
    RC_ASSERT((sum - big(large)).toDouble() == small);
}

RC_GTEST_PROP(BigFloat, dividesBackToTheFactor, ()) {
    const double a = anyNumber(-300, 300);
    const double b = anyNumber(-300, 300);
    const BigFloat difference = big(a) * big(b) / big(b) - big(a);
    RC_ASSERT(std::abs(difference.toDouble()) <= std::abs(a) * 0x1p-400);
}

RC_GTEST_PROP(BigFloat, halvesExactly, ()) {
    const double a = anyNumber(-300, 300);
    RC_ASSERT(big(a).half().toDouble() == a / 2);
}

TEST(BigFloat, hasExponentsBeyondThoseOfDoubles) {
    BigFloat power = big(1e300);
    for (int i = 0; i < 5; ++i)
        power = power * power;
    EXPECT_EQ(power.toDouble(), std::numeric_limits<double>::infinity());
    EXPECT_EQ((-power).toDouble(), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(reciprocal(power).toDouble(), 0);
    EXPECT_EQ((power * reciprocal(power) - big(1) + big(2)).toDouble(), 2);
}

TEST(BigFloat, splitsIntoTwoDoubles) {
    const DoubleDouble third = (big(1) / big(3)).toDoubleDouble();
    EXPECT_EQ(third.high, 1.0 / 3);
    EXPECT_EQ(third.low, (DoubleDouble(1) / 3).low);
    EXPECT_EQ((BigFloat(third, kDigits) - big(third.high)).toDouble(), third.low);
}

TEST(BigFloat, takesWhatRoundingsLeftForZero) {
    const BigFloat third = big(1) / big(3);
    EXPECT_EQ((third + third + third - big(1)).sign(), 0);
}

TEST(BigFloat, knowsZero) {
    EXPECT_EQ(BigFloat().toDouble(), 0);
    EXPECT_EQ((big(3) - big(3)).sign(), 0);
    EXPECT_EQ((big(3) * big(0) + big(2)).toDouble(), 2);
    EXPECT_EQ(big(0).half().sign(), 0);
}

} // namespace
} // namespace kriva
