#pragma once

#include <string>

namespace kriva {

/// A number in the C locale without exponent, rounded to so many decimals, without zeros at its end.
[[nodiscard]] std::string plainNumber(double value, int decimals);

} // namespace kriva
