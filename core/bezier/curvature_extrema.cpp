#include "core/bezier/curvature_extrema.h"

#include "core/bezier/curvature.h"
#include "core/polynomial/bernstein_polynomial.h"
#include "core/polynomial/casteljau.h"
#include "core/polynomial/hodograph_forms.h"
#include "core/polynomial/sign_changes.h"

#include <algorithm>

namespace kriva {

namespace {

/// Turns this near to an end belong to the knot there.
constexpr double kInside = 1e-9;

/// Each coefficient of a product is a mean of double-double products, so what it loses is some 2^-100 of the largest
/// ones; the rest leaves room for the sums and the binomial coefficients.
constexpr double kNoise = 0x1p-94;

using Exact = std::vector<DoubleDouble>;

/// A polynomial with a bound of its coefficients' rounding errors.
struct Noisy {
    Exact coefficients;
    double noise = 0;
};

Noisy turningOf(std::span<const Point> curve, double unit) {
    const ExactHodograph c = exactHodograph(curve, unit);
    const double largest = std::max(largestCoefficient(c.x), largestCoefficient(c.y));
    return {turning(c), kNoise * static_cast<double>(curve.size()) * largest * largest};
}

/// With X = c x c' and q = |c|^2 the curvature is X / q^(3/2), and its derivative by t is this over q^(5/2):
/// X' q - 3/2 X q'.
Noisy slopeNumerator(std::span<const Point> curve, double unit) {
    const ExactHodograph c = exactHodograph(curve, unit);
    const Exact x = turning(c);
    const Exact q = speedSquared(c);
    const Exact dx = differentiated(x);
    const Exact dq = differentiated(q);
    Exact rise = product(dx, q);
    Exact fall = product(x, dq);
    // Formally the first has one degree less where X is constant: it is zero then.
    rise.resize(fall.size());
    for (std::size_t i = 0; i < fall.size(); ++i)
        rise[i] = rise[i] - DoubleDouble(1.5) * fall[i];
    const double size = largestCoefficient(dx) * largestCoefficient(q) + largestCoefficient(x) * largestCoefficient(dq);
    return {rise, kNoise * size};
}

} // namespace

std::vector<double> inflections(std::span<const Point> curve) {
    if (isStraight(curve))
        return {};
    const Noisy x = turningOf(curve, unitOf(curve));
    return signChanges(x.coefficients, x.noise);
}

std::vector<double> curvatureExtrema(std::span<const Point> curve) {
    if (isStraight(curve))
        return {};
    const Noisy slope = slopeNumerator(curve, unitOf(curve));
    std::vector<double> found = signChanges(slope.coefficients, slope.noise);
    std::erase_if(found, [](double t) { return t <= kInside || t >= 1 - kInside; });
    return found;
}

std::optional<double> curvatureSlope(std::span<const Point> curve, double t) {
    if (curve.size() < 2)
        return std::nullopt;
    const double unit = unitOf(curve);
    const ExactHodograph c = exactHodograph(curve, unit);
    Exact speed = speedSquared(c);
    const auto q = static_cast<double>(valueInPlace(std::span(speed), t));
    if (q <= 0)
        return std::nullopt;
    if (isStraight(curve))
        return 0;
    Noisy slope = slopeNumerator(curve, unit);
    const auto numerator = static_cast<double>(valueInPlace(std::span(slope.coefficients), t));
    return std::abs(numerator) <= slope.noise ? 0 : numerator / (q * q * q) / unit / unit;
}

} // namespace kriva
