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

} // namespace kriva
