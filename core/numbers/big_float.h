#pragma once

#include "core/numbers/double_double.h"

#include <cstdint>
#include <vector>

namespace kriva {

/// A floating-point number of as many 64-bit digits as asked for, with an exponent that never overflows. Changing the
/// basis of a polynomial of high degree cancels hundreds of bits; with enough digits nothing visible is lost.
/// Results are cut off towards zero: their relative error is below 2^(64 - 64 digits). A difference in the last digit
/// alone is what such errors left, and zero.
class BigFloat {
  public:
    /// Zero.
    BigFloat() = default;
    /// The finite value, exactly; results that it takes part in keep at least `digits`, at least 2.
    BigFloat(double value, int digits);
    /// The finite value, cut off after `digits`.
    BigFloat(const DoubleDouble& value, int digits);

    [[nodiscard]] int sign() const { return sign_; }
    [[nodiscard]] BigFloat operator-() const;
    friend BigFloat operator+(const BigFloat& a, const BigFloat& b);
    friend BigFloat operator-(const BigFloat& a, const BigFloat& b) { return a + -b; }
    /// O(digits^2), less where a factor is short.
    friend BigFloat operator*(const BigFloat& a, const BigFloat& b);
    /// 1/b for b != 0, by Newton's iteration, O(digits^2 log digits).
    friend BigFloat reciprocal(const BigFloat& b);
    friend BigFloat operator/(const BigFloat& a, const BigFloat& b) { return a * reciprocal(b); }
    /// Exact, but for what lies below the last digit.
    [[nodiscard]] BigFloat half() const;

    /// The nearest double; infinite beyond their range.
    [[nodiscard]] double toDouble() const;
    [[nodiscard]] DoubleDouble toDoubleDouble() const;

  private:
    using Digit = std::uint64_t;

    [[nodiscard]] std::int64_t lowest() const { return exponent_ - static_cast<std::int64_t>(digits_.size()); }
    /// The digit worth 2^(64 position).
    [[nodiscard]] Digit digitAt(std::int64_t position) const;
    void normalise();
    static bool isSmaller(const BigFloat& a, const BigFloat& b);
    static BigFloat sumOfMagnitudes(const BigFloat& a, const BigFloat& b);
    static BigFloat differenceOfMagnitudes(const BigFloat& a, const BigFloat& b);

    // The value is sign * (sum over i of digits[i] 2^(64 (exponent - size + i))), first and last digit not zero.
    std::vector<Digit> digits_;
    std::int64_t exponent_ = 0;
    int sign_ = 0;
    int precision_ = 2; ///< most digits that are kept
};

} // namespace kriva
