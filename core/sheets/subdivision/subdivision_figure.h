#pragma once

#include "core/budget/work_budget.h"
#include "core/curve/editing/drawn_curve.h"
#include "core/sheets/subdivision/subdivision.h"

namespace kriva {

/// The layers of the sheet, from the lowest to the topmost.
[[nodiscard]] std::span<const LayerInfo> layersOf(const SubdivisionCurve& curve);

/// The layers of one curve. Those that a view hides may be missing or not; without a view all are there.
[[nodiscard]] Figure figureOf(const SubdivisionCurve& curve, const FigureContext& context);

/// About how many steps of a budget that takes: by them long work is told from what a frame has time for.
[[nodiscard]] std::uint64_t drawingSteps(const SubdivisionCurve& curve);

} // namespace kriva
