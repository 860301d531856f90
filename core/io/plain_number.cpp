#include "core/io/plain_number.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
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

constexpr std::array<double, 14> kPowers{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13};

/// The value in units of its last decimal, where a double tells how it is rounded: the product is off by at most
/// 2^-8 below 2^45, so that only near a half the exact value must decide.
std::optional<std::int64_t> inUnits(double value, int decimals) {
    constexpr double kMost = 0x1p45;
    constexpr double kOff = 0x1p-8;
    if (decimals < 0 || decimals >= static_cast<int>(kPowers.size()))
        return {};
    const double product = value * kPowers[static_cast<std::size_t>(decimals)];
    if (!(std::abs(product) < kMost))
        return {};
    const auto units = static_cast<std::int64_t>(product + (product < 0 ? -0.5 : 0.5));
    const double rest = std::abs(product - static_cast<double>(units));
    return rest < 0.5 - kOff ? std::optional(units) : std::nullopt;
}

char* writeUnits(char* to, std::int64_t units, int decimals) {
    if (units < 0)
        *to++ = '-';
    auto rest = static_cast<std::uint64_t>(units < 0 ? -units : units);
    while (decimals > 0 && rest % 10 == 0 && rest != 0) {
        rest /= 10;
        --decimals;
    }
    if (rest == 0) {
        *to++ = '0';
        return to;
    }
    // Copied by a fixed length, which is two instructions; what is behind the digits is overwritten by what comes next.
    constexpr std::size_t kMostDigits = 24;
    std::array<char, 2 * kMostDigits> digits{};
    char* const end = digits.data() + kMostDigits;
    char* first = end;
    for (; rest >= 100; rest /= 100)
        std::memcpy(first -= 2, &kPairs[2 * (rest % 100)], 2);
    if (rest >= 10)
        std::memcpy(first -= 2, &kPairs[2 * rest], 2);
    else
        *--first = static_cast<char>('0' + rest);
    while (end - first <= decimals)
        *--first = '0';
    const char* const point = end - decimals;
    std::memcpy(to, first, kMostDigits);
    to += point - first;
    if (decimals == 0)
        return to;
    *to++ = '.';
    std::memcpy(to, point, kMostDigits);
    return to + decimals;
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
    const std::optional<std::int64_t> units = inUnits(value, decimals);
    return units ? writeUnits(to, *units, decimals) : writeExactly(to, value, decimals);
}

std::string plainNumber(double value, int decimals) {
    std::array<char, kLongestPlainNumber> text; // the largest double has 309 digits before the point
    return {text.data(), writePlainNumber(text.data(), value, decimals)};
}

} // namespace kriva
