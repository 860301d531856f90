#pragma once

#include "core/figure/figure.h"
#include "core/subdivision/subdivision.h"

namespace kriva {

/// The layers of the sheet, from the lowest to the topmost.
[[nodiscard]] std::span<const LayerInfo> layersOf(const SubdivisionCurve& curve);

/// The layers of one curve. Those that a view hides may be missing or not; without a view all are there.
[[nodiscard]] Figure figureOf(const SubdivisionCurve& curve, const FigureContext& context);

} // namespace kriva
