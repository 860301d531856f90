#pragma once

#include "core/combined/combined_curve.h"
#include "core/figure/figure.h"

namespace kriva {

/// The layers of the sheet, from the lowest to the topmost.
[[nodiscard]] std::span<const LayerInfo> layersOf(const CombinedCurve& curve);

/// How many stages the algorithm has: the given points, their runs, the runs' polynomials, what joins them, the whole.
inline constexpr int kCombinedStages = 5;

/// The layers of one curve. Those that a view hides may be missing or not; without a view all are there. Pieces beyond
/// the range of doubles are left out.
[[nodiscard]] Figure figureOf(const CombinedCurve& curve, const FigureContext& context);

} // namespace kriva
