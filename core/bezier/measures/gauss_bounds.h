#pragma once

#include "core/polynomial/gauss_legendre.h"

#include <algorithm>
#include <bit>
#include <cstdint>

/// How exact the rules of CentredRule are. For an integrand that is analytic and at most M in a Bernstein ellipse
/// around an interval of length w, one whose axes add up to rho times w, N points leave an error of at most 32/15 w M
/// rho^(-2 N) / (1 - rho^-2). Source: Trefethen, Is Gauss quadrature better than Clenshaw-Curtis?, SIAM Review 50
/// (2008), theorem 4.5.
namespace kriva {

/// Errors are told by their step s: 4^-s, relative to w M.
inline constexpr std::size_t kErrorSteps = 34;

/// A step whose error, times this w M, is at most `error`, as far as there are steps.
[[nodiscard, gnu::always_inline]] inline std::size_t errorStep(double error, double most) {
    const auto exponentOf = [](double value) { return static_cast<int>(std::bit_cast<std::uint64_t>(value) >> 52); };
    const int bits = exponentOf(most) + 1 - exponentOf(error);
    return static_cast<std::size_t>(std::clamp((bits + 1) / 2, 0, static_cast<int>(kErrorSteps) - 1));
}

/// The error of a step.
[[nodiscard]] constexpr double errorOfStep(std::size_t step) {
    return std::bit_cast<double>((std::bit_cast<std::uint64_t>(1.0)) - (static_cast<std::uint64_t>(2 * step) << 52));
}

/// By index of the rule, the longer axis, in units of w, of the smallest ellipse in which it makes errors of a step. At
/// step 0 every rule will do: the integral and its sum are between 0 and w M.
[[nodiscard]] const std::array<double, CentredRule::kSizes.size()>& neededAxes(std::size_t step);

} // namespace kriva
