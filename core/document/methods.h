#pragma once

#include "core/budget/work_budget.h"
#include "core/curve/table.h"
#include "core/sheets/combined/combined_curve.h"

namespace kriva {

/// The same points under interpolation, approximation of degrees 2 to 5, pairs and as a natural spline: residual, the
/// largest kink, slope variation, bending energy and length of each, the least of them marked. A method whose limits
/// the points exceed has no numbers. Empty for fewer than two points.
[[nodiscard]] std::optional<Table> compareMethods(const CombinedCurve& curve, WorkBudget& budget);

} // namespace kriva
