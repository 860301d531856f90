#include "core/bezier/measures/cusp_window.h"

#include "core/bezier/measures/gauss_bounds.h"

namespace kriva {

namespace {

/// How near a zero is, relative to its distance from the nearer end, where a window takes less time.
constexpr double kNear = 1.0 / 16;

/// A smaller imaginary part is taken as this one: it changes |c| by no more, where the window has about as many of its
/// weights, and so the integral by about 1e-15 of the whole.
constexpr double kLeastImaginary = 1e-8;

/// The top at most: twice as far as the singularity is, which leaves 48 points exact enough.
constexpr double kHighestTop = 4;

/// The error of the rule, relative to what bounds the integrand: these bounds are about 100 times the integral.
constexpr std::size_t kStep = 27;

/// The z with C(z) = value > 4, to some digits: by Newton's method from a third of the exponent.
double roughInverse(double value) {
    constexpr auto kOne = std::bit_cast<std::uint64_t>(1.0);
    double z = std::bit_cast<double>((std::bit_cast<std::uint64_t>(value) - kOne) / 3 + kOne);
    for (int step = 0; step < 3; ++step)
        z = (2 * z * z * z + value) / (3 * z * z + 3);
    return z;
}

/// A bound of the error of a rule; nothing where the ellipse that it needs reaches to a zero.
std::optional<double> errorBound(const CuspWindow& window, std::size_t rule, double otherSize, double slope) {
    double farthest = neededAxes(kStep)[rule] * window.top; // of the ellipse, whose foci are -top and top
    if (farthest * farthest > window.top * window.top + 4)
        return {};
    // C has no negative coefficient: it is nowhere larger than at this end.
    double steepest = window.imaginary / 2;
    substitute(window.depth, farthest, steepest);
    farthest *= window.imaginary / 2;
    if (farthest * slope > otherSize)
        return {};
    return (farthest + window.imaginary) * (otherSize + farthest * slope) * steepest * 2 * window.top *
           errorOfStep(kStep);
}

std::optional<CuspWindow> windowAround(const HodographFactors::Zero& zero, double slope, double error) {
    const double room = std::min(zero.at.x, 1 - zero.at.x);
    if (!(std::abs(zero.at.y) < kNear * room))
        return {};
    CuspWindow window;
    window.middle = zero.at.x;
    window.imaginary = std::max(std::abs(zero.at.y), kLeastImaginary);
    // As wide as the other zero allows, which the ellipse must leave out.
    const double wanted = 0.9 * std::min(room, zero.otherSize / (4 * slope));
    window.top = 2 * wanted / window.imaginary;
    for (; window.top > kHighestTop; ++window.depth)
        window.top = roughInverse(window.top);
    window.halfWidth = window.top;
    double slopeOfEnd = 1;
    substitute(window.depth, window.halfWidth, slopeOfEnd);
    window.halfWidth *= window.imaginary / 2;
    if (window.depth == 0 || !(window.halfWidth < room))
        return {};
    for (; window.rule < CentredRule::kSizes.size(); ++window.rule)
        if (const std::optional<double> bound = errorBound(window, window.rule, zero.otherSize, slope)) {
            window.error = *bound;
            return *bound <= error ? std::optional(window) : std::nullopt;
        }
    return {};
}

} // namespace

std::optional<CuspWindow> cuspWindow(const HodographFactors& factors, double error) {
    if (const auto window = windowAround(factors.firstZero(), factors.slope(), error))
        return window;
    return windowAround(factors.secondZero(), factors.slope(), error);
}

} // namespace kriva
