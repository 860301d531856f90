#include "core/bezier/measures/curvature_extrema.h"

#include "core/bezier/measures/curvature.h"
#include "core/polynomial/bernstein_polynomial.h"
#include "core/polynomial/casteljau.h"
#include "core/polynomial/hodograph_forms.h"
#include "core/polynomial/sign_changes.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace kriva {

namespace {

/// Turns this near to an end belong to the knot there.
constexpr double kInside = 1e-9;

/// What one operation loses, relative to the operands.
template <class T>
constexpr double kRounding = std::is_same_v<T, double> ? std::numeric_limits<double>::epsilon() / 2 : 0x1p-102;

/// A polynomial with a bound of its coefficients' rounding errors.
template <class T>
struct Noisy {
    std::vector<T> coefficients;
    double noise = 0;
};

/// What bounds the forms of a hodograph: its degree, at least 1, and the square of its largest vector at most.
struct Sizes {
    double degree = 0;
    double speedSquared = 0;
};

template <class T>
Sizes sizesOf(const Hodograph<T>& c) {
    const double x = largestCoefficient(c.x);
    const double y = largestCoefficient(c.y);
    return {std::max(1.0, static_cast<double>(c.x.size() - 1)), x * x + y * y};
}

/// A coefficient of a product of polynomials of degree d is a mean of d + 1 products, each of them rounded some eight
/// times with its binomial coefficients, which carry d roundings; the sum rounds d times.
template <class T>
double roundingOfProduct(double degree) {
    return kRounding<T> * (8 + 4 * degree);
}

/// c x c'. Its coefficients are at most degree |c|^2, a product of polynomials of degree d - 1.
template <class T>
Noisy<T> turningOf(const Hodograph<T>& c) {
    const Sizes sizes = sizesOf(c);
    return {turning(c), roundingOfProduct<T>(sizes.degree) * 2 * sizes.degree * sizes.speedSquared};
}

/// With X = c x c' and q = |c|^2 the curvature is X / q^(3/2), and its derivative by t is this over q^(5/2):
/// X' q - 3/2 X q'.
template <class T>
Noisy<T> slopeNumerator(const Hodograph<T>& c) {
    const std::vector<T> x = turning(c);
    const std::vector<T> q = speedSquared(c);
    std::vector<T> rise = product(differentiated(x), q);
    const std::vector<T> fall = product(x, differentiated(q));
    // Where X is constant, its derivative counts as a zero of degree 0, one more than it should have.
    rise.resize(fall.size());
    for (std::size_t i = 0; i < fall.size(); ++i)
        rise[i] = rise[i] - T(1.5) * fall[i];
    // |X| <= d |c|^2, |X'| <= 4 d |X|, |q'| <= 4 d |c|^2: the terms are at most 4 d^2 and 6 d^2 of |c|^4, and both
    // factors carry the errors of their own products.
    const auto [degree, speed] = sizesOf(c);
    return {rise, 3 * roundingOfProduct<T>(2 * degree) * 10 * degree * degree * speed * speed};
}

/// The sign changes of a form of the curve, in doubles where these can tell, else in double-double.
template <class Form>
std::vector<double> signChangesOf(std::span<const Point> curve, Form form) {
    const double unit = unitOf(curve);
    const auto quick = form(hodographIn<double>(unit, curve));
    if (auto found = certainSignChanges(quick.coefficients, quick.noise))
        return *std::move(found);
    const auto exact = form(hodographIn<DoubleDouble>(unit, curve));
    return signChanges(exact.coefficients, exact.noise);
}

} // namespace

std::vector<double> inflections(std::span<const Point> curve) {
    if (isStraight(curve))
        return {};
    return signChangesOf(curve, [](const auto& c) { return turningOf(c); });
}

std::vector<double> curvatureExtrema(std::span<const Point> curve) {
    if (isStraight(curve))
        return {};
    std::vector<double> found = signChangesOf(curve, [](const auto& c) { return slopeNumerator(c); });
    std::erase_if(found, [](double t) { return t <= kInside || t >= 1 - kInside; });
    return found;
}

std::optional<double> curvatureSlope(std::span<const Point> curve, double t) {
    if (curve.size() < 2)
        return std::nullopt;
    const double unit = unitOf(curve);
    const auto c = hodographIn<DoubleDouble>(unit, curve);
    std::vector<DoubleDouble> speed = speedSquared(c);
    const auto q = static_cast<double>(valueInPlace(std::span(speed), t));
    if (q <= 0)
        return std::nullopt;
    if (isStraight(curve))
        return 0;
    auto slope = slopeNumerator(c);
    const auto numerator = static_cast<double>(valueInPlace(std::span(slope.coefficients), t));
    return std::abs(numerator) <= slope.noise ? 0 : numerator / (q * q * q) / unit / unit;
}

} // namespace kriva
