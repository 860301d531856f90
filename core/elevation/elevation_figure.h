#pragma once

#include "core/elevation/elevation.h"
#include "core/figure/figure.h"

#include <array>

namespace kriva {

/// The layers of the sheet, from the lowest to the topmost.
[[nodiscard]] std::span<const LayerInfo> layersOf(const ElevationCurve& curve);

/// All layers of one curve, also those that a view hides.
[[nodiscard]] Figure figureOf(const ElevationCurve& curve, const FigureContext& context);

} // namespace kriva
