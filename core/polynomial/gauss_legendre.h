#pragma once

#include <array>
#include <span>

namespace kriva {

/// One node of a quadrature rule over [0, 1], in the lower half, standing for itself and its mirror image 1 - at.
struct GaussNode {
    double at = 0;
    double weight = 0;
};

/// The Gauss-Legendre rules at hand, by rising number of points; every number is even, so no node is at 1/2.
inline constexpr std::array kGaussSizes{8, 12, 16, 24, 32, 48, 64, 96, 128};

/// The lower half of the rule of kGaussSizes[index] points, right to the last place or two.
[[nodiscard]] std::span<const GaussNode> gaussNodes(std::size_t index);

/// A rule over an interval of length 1 by its nodes above the middle, which stand for their mirror images too: for
/// loops that take four of them at once.
struct CentredRule {
    static constexpr std::array kSizes{8, 16, 24, 32, 48, 64}; ///< halves of these fill registers of four

    std::size_t half = 0;                            ///< how many nodes and weights follow
    std::array<double, kSizes.back() / 2> offsets{}; ///< from the middle
    std::array<double, kSizes.back() / 2> weights{};
};

/// The rule of CentredRule::kSizes[index] points.
[[nodiscard]] const CentredRule& centredRule(std::size_t index);

} // namespace kriva
