#include "core/io/numbers/plain_number.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

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

/// What the fast way writes is what the exact value says, ties and all.
RC_GTEST_PROP(PlainNumber, isRoundedByTheExactValue, ()) {
    const int decimals = *rc::gen::inRange(0, 20);
    const auto bits = *rc::gen::arbitrary<std::uint64_t>();
    const double value =
        *rc::gen::element(std::bit_cast<double>(bits), std::ldexp(static_cast<double>(bits % 4'000'001) - 2e6, -7),
                          static_cast<double>(bits) * 1e-17, (static_cast<double>(bits % 20'001) + 0.5) * 1e-3);
    RC_PRE(std::isfinite(value));
    std::array<char, 512> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals).ptr;
    std::string expected(digits.data(), end);
    if (expected.find('.') != std::string::npos)
        expected.erase(expected.find_last_not_of('0') + 1);
    if (expected.ends_with('.'))
        expected.pop_back();
    RC_ASSERT(plainNumber(value, decimals) == (expected == "-0" ? "0" : expected));
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
