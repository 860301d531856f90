#pragma once

#include "core/combined/combined_curve.h"
#include "core/figure/figure.h"

namespace kriva {

/// The layers of the sheet, from the lowest to the topmost.
[[nodiscard]] std::span<const LayerInfo> layersOf(const CombinedCurve& curve);

/// All layers of one curve, also those that a view hides. Pieces beyond the range of doubles are left out.
[[nodiscard]] Figure figureOf(const CombinedCurve& curve, const FigureContext& context);

} // namespace kriva
