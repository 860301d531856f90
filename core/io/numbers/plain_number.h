#pragma once

#include <cstddef>
#include <string>

namespace kriva {

/// A number in the C locale without exponent, rounded to so many decimals, without zeros at its end.
[[nodiscard]] std::string plainNumber(double value, int decimals);

/// More characters than any number has with decimals up to 60.
inline constexpr std::size_t kLongestPlainNumber = 400;

/// The same into memory with room for kLongestPlainNumber; gives the end. Some 6 ns where the digits before and behind
/// the point are 13 at most.
[[nodiscard]] char* writePlainNumber(char* to, double value, int decimals);

} // namespace kriva
