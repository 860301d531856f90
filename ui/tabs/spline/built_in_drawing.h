#pragma once

#include "core/budget/work_budget.h"
#include "core/sheets/spline/chain/spline_curve.h"

namespace kriva::ui {

/// How far Qt's own drawing of a spline and its de Casteljau polyline of so many points per segment are apart, in
/// document units: the largest distance of a corner of either from the other. Qt draws a path as short lines of its own
/// choice; here it is asked for those of a chain whose longer side is 1000 pixels. Degrees above 3, which Qt has not,
/// are drawn as cubics, as on the canvas. 0 for incomplete curves and chains without extent.
/// O(segments points), with some 20 lines a segment; nothing where the budget ends.
[[nodiscard]] std::optional<double> deviationFromBuiltIn(const SplineCurve& curve, int points, WorkBudget& budget);

} // namespace kriva::ui
