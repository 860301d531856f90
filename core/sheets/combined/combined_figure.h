#pragma once

#include "core/budget/work_budget.h"
#include "core/curve/editing/drawn_curve.h"
#include "core/sheets/combined/combined_curve.h"

namespace kriva {

/// The layers of the sheet, from the lowest to the topmost.
[[nodiscard]] std::span<const LayerInfo> layersOf(const CombinedCurve& curve);

/// How many stages the algorithm has: the given points, their runs, the runs' polynomials, what joins them, the whole.
inline constexpr int kCombinedStages = 5;

/// The layers of one curve. Those that a view hides may be missing or not; without a view all are there. Pieces beyond
/// the range of doubles are left out.
[[nodiscard]] Figure figureOf(const CombinedCurve& curve, const FigureContext& context);

/// What is drawn of one curve; nothing where the budget ends.
[[nodiscard]] std::optional<DrawnCurve> drawn(const CombinedCurve& curve, const FigureContext& context,
                                              WorkBudget& budget);
/// About how many steps of a budget that takes: by them long work is told from what a frame has time for.
[[nodiscard]] std::uint64_t drawingSteps(const CombinedCurve& curve);

} // namespace kriva
