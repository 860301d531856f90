#include "core/numbers/big_float.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>

namespace kriva {
namespace {

__extension__ using Wide = unsigned __int128;
constexpr int kDigitBits = 64;

} // namespace

BigFloat::BigFloat(double value, int digits)
    : precision_(std::max(digits, 2)) {
    assert(std::isfinite(value));
    if (value == 0)
        return;
    constexpr int kBits = std::numeric_limits<double>::digits;
    int power = 0;
    const double fraction = std::frexp(std::abs(value), &power);
    power -= kBits;
    const int position = (power >= 0 ? power : power - kDigitBits + 1) / kDigitBits; // rounded down
    const Wide shifted = static_cast<Wide>(static_cast<Digit>(std::ldexp(fraction, kBits)))
                         << (power - kDigitBits * position);
    sign_ = value < 0 ? -1 : 1;
    digits_ = {static_cast<Digit>(shifted), static_cast<Digit>(shifted >> kDigitBits)};
    exponent_ = position + 2;
    normalise();
}

BigFloat::BigFloat(const DoubleDouble& value, int digits) {
    *this = BigFloat(value.high, digits) + BigFloat(value.low, digits);
}

void BigFloat::normalise() {
    while (!digits_.empty() && digits_.back() == 0) {
        digits_.pop_back();
        --exponent_;
    }
    if (digits_.empty()) {
        exponent_ = 0;
        sign_ = 0;
        return;
    }
    const auto kept = std::min(digits_.size(), static_cast<std::size_t>(precision_));
    auto first = digits_.end() - static_cast<std::ptrdiff_t>(kept);
    while (*first == 0)
        ++first;
    digits_.erase(digits_.begin(), first);
}

BigFloat::Digit BigFloat::digitAt(std::int64_t position) const {
    return position >= lowest() && position < exponent_ ? digits_[static_cast<std::size_t>(position - lowest())] : 0;
}

BigFloat BigFloat::operator-() const {
    BigFloat negated = *this;
    negated.sign_ = -sign_;
    return negated;
}

bool BigFloat::isSmaller(const BigFloat& a, const BigFloat& b) {
    if (a.exponent_ != b.exponent_)
        return a.exponent_ < b.exponent_;
    return std::lexicographical_compare(a.digits_.rbegin(), a.digits_.rend(), b.digits_.rbegin(), b.digits_.rend());
}

BigFloat BigFloat::sumOfMagnitudes(const BigFloat& a, const BigFloat& b) {
    BigFloat sum;
    sum.precision_ = std::max(a.precision_, b.precision_);
    sum.sign_ = 1;
    const std::int64_t top = std::max(a.exponent_, b.exponent_);
    const std::int64_t bottom = std::max(std::min(a.lowest(), b.lowest()), top - sum.precision_);
    sum.digits_.reserve(static_cast<std::size_t>(top - bottom) + 1);
    Wide carry = 0;
    for (std::int64_t position = bottom; position < top; ++position) {
        carry += static_cast<Wide>(a.digitAt(position)) + b.digitAt(position);
        sum.digits_.push_back(static_cast<Digit>(carry));
        carry >>= kDigitBits;
    }
    sum.digits_.push_back(static_cast<Digit>(carry));
    sum.exponent_ = top + 1;
    sum.normalise();
    return sum;
}

/// |a| >= |b|
BigFloat BigFloat::differenceOfMagnitudes(const BigFloat& a, const BigFloat& b) {
    BigFloat difference;
    difference.precision_ = std::max(a.precision_, b.precision_);
    difference.sign_ = 1;
    difference.exponent_ = a.exponent_;
    const std::int64_t bottom = std::max(std::min(a.lowest(), b.lowest()), a.exponent_ - difference.precision_);
    difference.digits_.reserve(static_cast<std::size_t>(a.exponent_ - bottom));
    Digit borrow = 0;
    for (std::int64_t position = bottom; position < a.exponent_; ++position) {
        const Wide taken = static_cast<Wide>(b.digitAt(position)) + borrow;
        const Digit from = a.digitAt(position);
        difference.digits_.push_back(from - static_cast<Digit>(taken));
        borrow = taken > from ? 1 : 0;
    }
    difference.normalise();
    if (difference.exponent_ <= a.exponent_ - difference.precision_ + 1)
        return {0, difference.precision_};
    return difference;
}

BigFloat operator+(const BigFloat& a, const BigFloat& b) {
    BigFloat sum;
    if (a.sign_ == 0 || b.sign_ == 0) {
        sum = a.sign_ == 0 ? b : a;
        sum.precision_ = std::max(a.precision_, b.precision_);
        return sum;
    }
    const bool swapped = BigFloat::isSmaller(a, b);
    const BigFloat& large = swapped ? b : a;
    const BigFloat& small = swapped ? a : b;
    sum = a.sign_ == b.sign_ ? BigFloat::sumOfMagnitudes(large, small) : BigFloat::differenceOfMagnitudes(large, small);
    sum.sign_ *= large.sign_;
    return sum;
}

BigFloat operator*(const BigFloat& a, const BigFloat& b) {
    BigFloat product;
    product.precision_ = std::max(a.precision_, b.precision_);
    product.sign_ = a.sign_ * b.sign_;
    if (product.sign_ == 0)
        return product;
    product.exponent_ = a.exponent_ + b.exponent_;
    product.digits_.assign(a.digits_.size() + b.digits_.size(), 0);
    for (std::size_t i = 0; i < a.digits_.size(); ++i) {
        Wide carry = 0;
        for (std::size_t j = 0; j < b.digits_.size(); ++j) {
            carry += static_cast<Wide>(a.digits_[i]) * b.digits_[j] + product.digits_[i + j];
            product.digits_[i + j] = static_cast<BigFloat::Digit>(carry);
            carry >>= kDigitBits;
        }
        product.digits_[i + b.digits_.size()] = static_cast<BigFloat::Digit>(carry);
    }
    product.normalise();
    return product;
}

BigFloat reciprocal(const BigFloat& b) {
    // The first approximation, good to 52 bits, is taken with the exponent set aside, which doubles may not hold.
    BigFloat mantissa = b;
    mantissa.exponent_ = 0;
    BigFloat result(1 / mantissa.toDouble(), b.precision_);
    result.exponent_ -= b.exponent_;
    const BigFloat one(1, b.precision_);
    for (int bits = 50; bits < kDigitBits * b.precision_; bits *= 2)
        result = result + result * (one - b * result);
    return result;
}

BigFloat BigFloat::half() const {
    BigFloat result = *this;
    result.digits_.insert(result.digits_.begin(), 0);
    Digit carry = 0;
    for (auto digit = result.digits_.rbegin(); digit != result.digits_.rend(); ++digit) {
        const Digit halved = (*digit >> 1) | carry;
        carry = *digit << (kDigitBits - 1);
        *digit = halved;
    }
    result.normalise();
    return result;
}

double BigFloat::toDouble() const {
    if (sign_ == 0)
        return 0;
    // The leading 64 bits, the last of them set where anything follows: then one rounding to 53 bits is the right one.
    const int zeros = std::countl_zero(digits_.back());
    const Digit next = digitAt(exponent_ - 2);
    Digit leading = digits_.back() << zeros;
    if (zeros > 0)
        leading |= next >> (kDigitBits - zeros);
    if (next << zeros != 0 || digits_.size() > 2)
        leading |= 1;
    const std::int64_t power = kDigitBits * (exponent_ - 1) - zeros;
    constexpr std::int64_t kBeyond = 5000; // every double lies between 2^-1075 and 2^1024
    return sign_ * std::ldexp(static_cast<double>(leading), static_cast<int>(std::clamp(power, -kBeyond, kBeyond)));
}

DoubleDouble BigFloat::toDoubleDouble() const {
    const double high = toDouble();
    if (!std::isfinite(high))
        return high;
    return {high, (*this - BigFloat(high, precision_)).toDouble()};
}

} // namespace kriva
