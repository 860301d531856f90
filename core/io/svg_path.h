#pragma once

#include "core/figure/figure.h"
#include "core/figure/page.h"

#include <string>

namespace kriva {

/// How far a cubic that stands for a piece of degree 4 and above may be from it, in millimetres.
inline constexpr double kCubicTolerance = 0.001;

/// The `d` of an SVG path in millimetres of the page with so many decimals: pieces of degree 1, 2, 3 as exact L, Q, C,
/// higher ones as C within kCubicTolerance; a closed path ends in Z. Empty where the path has no piece.
[[nodiscard]] std::string pathData(const Path& path, const Page& page, int decimals);

/// The decimals that keep a coordinate of the page to 1e-13 of its longer side.
[[nodiscard]] int decimalsOf(const Page& page);

} // namespace kriva
