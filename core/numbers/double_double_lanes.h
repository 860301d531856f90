#pragma once

#include "core/numbers/double_double.h"

#include <cstring>

namespace kriva {

/// Four double-doubles, added and multiplied at once where the processor has registers so wide: each to the last bit as
/// one alone. For loops in functions with a target of such registers; all is inlined there, since vectors are handed
/// over otherwise in every target.
struct DoubleDoubleLanes {
    using Lanes [[gnu::vector_size(32)]] = double;
    static constexpr std::size_t kCount = sizeof(Lanes) / sizeof(double);

    Lanes high{};
    Lanes low{};

    /// From so many numbers at both places.
    [[nodiscard, gnu::always_inline]] static DoubleDoubleLanes at(const double* high, const double* low) {
        DoubleDoubleLanes lanes;
        std::memcpy(&lanes.high, high, sizeof lanes.high);
        std::memcpy(&lanes.low, low, sizeof lanes.low);
        return lanes;
    }
    [[nodiscard, gnu::always_inline]] DoubleDouble operator[](std::size_t lane) const {
        return {high[lane], low[lane]};
    }
};

namespace lanes {

using Lanes = DoubleDoubleLanes::Lanes;

/// result = a b + c with one rounding.
[[gnu::always_inline]] inline void multiplyAdd(const Lanes& a, const Lanes& b, const Lanes& c, Lanes& result) {
    for (std::size_t i = 0; i < DoubleDoubleLanes::kCount; ++i)
        result[i] = std::fma(a[i], b[i], c[i]);
}
[[nodiscard, gnu::always_inline]] inline DoubleDoubleLanes exactSum(const Lanes& a, const Lanes& b) {
    const Lanes sum = a + b;
    const Lanes ofB = sum - a;
    return {sum, (a - (sum - ofB)) + (b - ofB)};
}
[[nodiscard, gnu::always_inline]] inline DoubleDoubleLanes exactSumOrdered(const Lanes& a, const Lanes& b) {
    const Lanes sum = a + b;
    return {sum, b - (sum - a)};
}

} // namespace lanes

[[nodiscard, gnu::always_inline]] inline DoubleDoubleLanes operator+(const DoubleDoubleLanes& a,
                                                                     const DoubleDoubleLanes& b) {
    const DoubleDoubleLanes high = lanes::exactSum(a.high, b.high);
    const DoubleDoubleLanes low = lanes::exactSum(a.low, b.low);
    const DoubleDoubleLanes sum = lanes::exactSumOrdered(high.high, high.low + low.high);
    return lanes::exactSumOrdered(sum.high, low.low + sum.low);
}
[[nodiscard, gnu::always_inline]] inline DoubleDoubleLanes operator*(const DoubleDoubleLanes& a,
                                                                     const DoubleDoubleLanes& b) {
    const DoubleDoubleLanes::Lanes product = a.high * b.high;
    DoubleDoubleLanes::Lanes rest;
    DoubleDoubleLanes::Lanes middle;
    lanes::multiplyAdd(a.high, b.high, -product, rest);
    lanes::multiplyAdd(a.high, b.low, a.low * b.low, middle);
    lanes::multiplyAdd(a.low, b.high, middle, middle);
    return lanes::exactSumOrdered(product, rest + middle);
}

} // namespace kriva
