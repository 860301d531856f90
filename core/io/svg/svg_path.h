#pragma once

#include "core/figure/figure.h"
#include "core/figure/style/page.h"

#include <string>

namespace kriva {

/// The `d` of an SVG path in millimetres of the page with so many decimals: what forEachDrawnPiece() tells as L, Q, C;
/// a closed path ends in Z. Empty where the path has no piece.
[[nodiscard]] std::string pathData(const Path& path, const Page& page, int decimals);
/// The same behind a text, which takes half the time of a long path.
void appendPathData(std::string& text, const Path& path, const Page& page, int decimals);

/// The decimals that keep a coordinate of the page to 1e-13 of its longer side.
[[nodiscard]] int decimalsOf(const Page& page);

} // namespace kriva
