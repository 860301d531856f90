#pragma once

#include "core/figure/figure.h"
#include "core/spline/spline.h"

namespace kriva {

/// The layers of the sheet, from the lowest to the topmost.
[[nodiscard]] std::span<const LayerInfo> layersOf(const SplineCurve& curve);

/// All layers of one curve, also those that a view hides.
[[nodiscard]] Figure figureOf(const SplineCurve& curve, const FigureContext& context);

} // namespace kriva
