#pragma once

#include <cmath>

namespace kriva {

/// A real number as the unevaluated sum of two doubles, |low| <= ulp(high) / 2: about 32 significant digits. Fits are
/// computed in it, so that what they lose stays far below a rounding of the data.
/// Every operation has a relative error of a few 2^-104 where nothing over- or underflows.
/// Sources: Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971);
/// Joldes, Muller, Popescu, Tight and rigorous error bounds for basic building blocks of double-word arithmetic,
/// ACM TOMS 44 (2017), algorithms 6 (sum), 12 (product), 18 (quotient).
struct DoubleDouble {
    double high = 0;
    double low = 0;

    constexpr DoubleDouble() = default;
    constexpr DoubleDouble(double value) // NOLINT(google-explicit-constructor): every double is one, exactly
        : high(value) {}
    constexpr DoubleDouble(double h, double l)
        : high(h)
        , low(l) {}

    explicit constexpr operator double() const { return high; }
    friend constexpr bool operator==(const DoubleDouble&, const DoubleDouble&) = default;
};

/// a + b exactly (Knuth, The Art of Computer Programming, vol. 2, 4.2.2, theorem B).
[[nodiscard]] constexpr DoubleDouble exactSum(double a, double b) {
    const double sum = a + b;
    const double ofB = sum - a;
    return {sum, (a - (sum - ofB)) + (b - ofB)};
}
/// a + b exactly where |a| >= |b| or a = 0 (Dekker).
[[nodiscard]] constexpr DoubleDouble exactSumOrdered(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}
/// a b exactly.
[[nodiscard]] inline DoubleDouble exactProduct(double a, double b) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

constexpr DoubleDouble operator-(const DoubleDouble& a) {
    return {-a.high, -a.low};
}
constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble high = exactSum(a.high, b.high);
    const DoubleDouble low = exactSum(a.low, b.low);
    const DoubleDouble sum = exactSumOrdered(high.high, high.low + low.high);
    return exactSumOrdered(sum.high, low.low + sum.low);
}
constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
    return a + -b;
}
inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble high = exactProduct(a.high, b.high);
    const double middle = std::fma(a.low, b.high, std::fma(a.high, b.low, a.low * b.low));
    return exactSumOrdered(high.high, high.low + middle);
}
inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - b * first;
    const double second = rest.high / b.high;
    const DoubleDouble rest2 = rest - b * second;
    return exactSumOrdered(first, second) + rest2.high / b.high;
}

[[nodiscard]] constexpr DoubleDouble abs(const DoubleDouble& a) {
    return a.high < 0 ? -a : a;
}
/// 0 for 0; one step of Newton's iteration from the double root.
[[nodiscard]] inline DoubleDouble sqrt(const DoubleDouble& a) {
    const double root = std::sqrt(a.high);
    if (root == 0)
        return {};
    return exactSumOrdered(root, (a - exactProduct(root, root)).high / (2 * root));
}

} // namespace kriva
