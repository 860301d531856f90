#pragma once

#include "core/elevation/elevation.h"
#include "core/figure/figure.h"

#include <array>

namespace kriva {

/// The layers of the sheet, from the lowest to the topmost.
[[nodiscard]] std::span<const LayerInfo> layersOf(const ElevationCurve& curve);

/// The layers of one curve. Those that a view hides may be missing or not; without a view all are there.
[[nodiscard]] Figure figureOf(const ElevationCurve& curve, const FigureContext& context);

} // namespace kriva
