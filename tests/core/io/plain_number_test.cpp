#include "core/io/plain_number.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <charconv>
#include <cmath>

namespace kriva {
namespace {

TEST(PlainNumber, hasNoExponentAndNoIdleZeros) {
    EXPECT_EQ(plainNumber(120, 11), "120");
    EXPECT_EQ(plainNumber(0.1, 11), "0.1");
    EXPECT_EQ(plainNumber(-0.0, 4), "0");
    EXPECT_EQ(plainNumber(-1e-9, 4), "0");
    EXPECT_EQ(plainNumber(1.00004999, 4), "1");
    EXPECT_EQ(plainNumber(1e20, 0), "100000000000000000000");
    EXPECT_EQ(plainNumber(100, 0), "100");
}

RC_GTEST_PROP(PlainNumber, isWithinHalfOfItsLastDecimal, (int whole, int billionths)) {
    const double value = whole + billionths * 1e-9;
    const std::string text = plainNumber(value, 6);
    double read = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read, std::chars_format::fixed);
    RC_ASSERT(error == std::errc());
    RC_ASSERT(end == text.data() + text.size());
    RC_ASSERT(std::abs(read - value) <= 5.0001e-7 + 1e-15 * std::abs(value));
}

} // namespace
} // namespace kriva
