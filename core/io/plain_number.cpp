#include "core/io/plain_number.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

namespace kriva {
namespace {

/// "00", "01" and so on, up to "99".
constexpr std::array<char, 200> kPairs = [] {
    std::array<char, 200> pairs{};
    for (std::size_t i = 0; i < 100; ++i) {
        pairs[2 * i] = static_cast<char>('0' + i / 10);
        pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
    }
    return pairs;
}();

constexpr std::array<double, 15> kPowers{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14};

constexpr std::int64_t kUnsure = std::numeric_limits<std::int64_t>::min();

/// The value in units of its last decimal, where a double tells how it is rounded: the product is off by at most
/// 2^-8 below 2^45, so that only near a half the exact value must decide.
std::int64_t inUnits(double value, int decimals) {
    constexpr double kMost = 0x1p45;
    constexpr double kOff = 0x1p-8;
    constexpr int kMostDecimals = 13;
    if (decimals < 0 || decimals > kMostDecimals)
        return kUnsure;
    const double product = value * kPowers[static_cast<std::size_t>(decimals)];
    if (!(std::abs(product) < kMost))
        return kUnsure;
    const auto units = static_cast<std::int64_t>(product + std::copysign(0.5, product));
    return std::abs(product - static_cast<double>(units)) < 0.5 - kOff ? units : kUnsure;
}

int digitsOf(std::uint64_t number) {
    // The logarithm of 2 is 1233 / 4096 to four digits.
    const int least = static_cast<int>(std::bit_width(number | 1)) * 1233 >> 12;
    return least + static_cast<int>(static_cast<double>(number) >= kPowers[static_cast<std::size_t>(least)]);
}

/// Eight digits before `end`, with zeros in front, without a branch.
void writeEight(char* end, std::uint32_t number) {
    const std::uint32_t high = number / 10'000;
    const std::uint32_t low = number % 10'000;
    std::memcpy(end - 8, &kPairs[2 * (high / 100)], 2);
    std::memcpy(end - 6, &kPairs[2 * (high % 100)], 2);
    std::memcpy(end - 4, &kPairs[2 * (low / 100)], 2);
    std::memcpy(end - 2, &kPairs[2 * (low % 100)], 2);
}

char* writeUnits(char* to, std::int64_t units, int decimals) {
    constexpr std::uint64_t kEight = 100'000'000;
    constexpr std::size_t kMostDigits = 16; // of 2^45 or of 13 decimals and a zero before them
    if (units == 0) {
        *to = '0';
        return to + 1;
    }
    *to = '-';
    to += units < 0 ? 1 : 0;
    const auto number = static_cast<std::uint64_t>(units < 0 ? -units : units);
    std::array<char, 2 * kMostDigits> digits{};
    char* const end = digits.data() + kMostDigits;
    writeEight(end, static_cast<std::uint32_t>(number % kEight));
    writeEight(end - 8, static_cast<std::uint32_t>(number / kEight));
    const char* const first = end - std::max(digitsOf(number), decimals + 1);
    const char* const point = end - decimals;
    // Copied by a fixed length, which is two instructions; what is behind the digits is overwritten by what comes next.
    std::memcpy(to, first, kMostDigits);
    to += point - first;
    if (decimals == 0)
        return to;
    *to = '.';
    std::memcpy(to + 1, point, kMostDigits);
    to += 1 + decimals;
    while (to[-1] == '0')
        --to;
    return to[-1] == '.' ? to - 1 : to;
}

/// Of any number: by its exact value.
char* writeExactly(char* to, double value, int decimals) {
    char* end = std::to_chars(to, to + kLongestPlainNumber, value, std::chars_format::fixed, decimals).ptr;
    const std::string_view text(to, static_cast<std::size_t>(end - to));
    if (text.find('.') != std::string_view::npos)
        end = to + text.find_last_not_of('0') + 1;
    if (end[-1] == '.')
        --end;
    if (std::string_view(to, static_cast<std::size_t>(end - to)) == "-0") {
        *to = '0';
        end = to + 1;
    }
    return end;
}

} // namespace

char* writePlainNumber(char* to, double value, int decimals) {
    const std::int64_t units = inUnits(value, decimals);
    return units != kUnsure ? writeUnits(to, units, decimals) : writeExactly(to, value, decimals);
}

std::string plainNumber(double value, int decimals) {
    std::array<char, kLongestPlainNumber> text; // the largest double has 309 digits before the point
    return {text.data(), writePlainNumber(text.data(), value, decimals)};
}

} // namespace kriva
