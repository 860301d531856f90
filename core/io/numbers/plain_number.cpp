#include "core/io/numbers/plain_number.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>

namespace kriva {
namespace {

/// Three digits of a number, and how many they are without zeros at their end.
struct Group {
    std::array<char, 3> digits;
    std::uint8_t significant;
};

constexpr std::array<Group, 1000> kGroups = [] {
    std::array<Group, 1000> groups{};
    for (int i = 0; i < 1000; ++i) {
        Group& group = groups[static_cast<std::size_t>(i)];
        group.digits = {static_cast<char>('0' + i / 100), static_cast<char>('0' + i / 10 % 10),
                        static_cast<char>('0' + i % 10)};
        group.significant = i == 0 ? 0 : i % 10 != 0 ? 3 : i % 100 != 0 ? 2 : 1;
    }
    return groups;
}();

constexpr std::uint64_t powerOfTen(int exponent) {
    return exponent == 0 ? 1 : 10 * powerOfTen(exponent - 1);
}

/// Copies all of a group, which is one instruction; what is too much is overwritten by what comes next.
void copy(char* to, std::uint64_t group) {
    std::memcpy(to, &kGroups[group], sizeof(Group));
}

char* writeWhole(char* to, std::uint64_t whole) {
    if (whole >= 1000) {
        to = writeWhole(to, whole / 1000);
        copy(to, whole % 1000);
        return to + 3;
    }
    const int digits = 1 + static_cast<int>(whole >= 10) + static_cast<int>(whole >= 100);
    std::memcpy(to, kGroups[whole].digits.data() + 3 - digits, 3); // the last group has a byte behind its digits
    return to + digits;
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

/// By whole numbers: the value is counted in units of its last decimal. A double tells their number as long as the
/// product is below 2^45, where it is off by at most 2^-8, and not that near to a half.
template <int decimals>
char* writeUnits(char* to, double value) {
    constexpr double kMost = 0x1p45;
    constexpr double kOff = 0x1p-8;
    constexpr std::uint64_t kUnit = powerOfTen(decimals);
    const double product = std::abs(value) * static_cast<double>(kUnit);
    if (!(product < kMost))
        return writeExactly(to, value, decimals);
    const double raised = product + 0.5; // cut off below: the library's rounding takes as long as all the rest
    const auto units = static_cast<std::uint64_t>(static_cast<std::int64_t>(raised));
    if (std::abs(product - static_cast<double>(static_cast<std::int64_t>(units))) > 0.5 - kOff)
        return writeExactly(to, value, decimals);
    *to = '-';
    to += static_cast<int>(value < 0 && units > 0);
    to = writeWhole(to, units / kUnit);
    constexpr int kCount = (decimals + 2) / 3;
    std::uint64_t fraction = units % kUnit * powerOfTen(3 * kCount - decimals);
    if (fraction == 0)
        return to;
    *to++ = '.';
    std::array<std::uint64_t, kCount> groups{};
    for (std::size_t i = groups.size(); i-- > 0; fraction /= 1000)
        groups[i] = fraction % 1000;
    std::size_t last = 0;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        copy(to + 3 * i, groups[i]);
        if (groups[i] != 0)
            last = i;
    }
    return to + 3 * last + kGroups[groups[last]].significant;
}

using Writer = char* (*)(char*, double);

template <int... decimals>
constexpr std::array<Writer, sizeof...(decimals)> writers(std::integer_sequence<int, decimals...>) {
    return {writeUnits<decimals>...};
}

/// By the number of decimals.
constexpr auto kWriters = writers(std::make_integer_sequence<int, 14>());

} // namespace

char* writePlainNumber(char* to, double value, int decimals) {
    if (decimals < 0 || decimals >= static_cast<int>(kWriters.size()))
        return writeExactly(to, value, decimals);
    return kWriters[static_cast<std::size_t>(decimals)](to, value);
}

std::string plainNumber(double value, int decimals) {
    std::array<char, kLongestPlainNumber> text; // the largest double has 309 digits before the point
    return {text.data(), writePlainNumber(text.data(), value, decimals)};
}

} // namespace kriva
