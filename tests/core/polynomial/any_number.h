#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <cstdint>

namespace kriva {

/// Inside a property: a double with all its bits in use, its absolute value between 2^low and 2^(high + 1).
inline double anyNumber(int low, int high) {
    const auto bits = *rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 52);
    const double mantissa = 1 + static_cast<double>(bits) * 0x1p-52;
    return std::ldexp(*rc::gen::arbitrary<bool>() ? mantissa : -mantissa, *rc::gen::inRange(low, high + 1));
}

} // namespace kriva
