#pragma once

#include "core/budget/work_budget.h"
#include "core/curve/table.h"
#include "core/sheets/spline/chain/spline.h"

namespace kriva {

/// The coefficients of the segments in the powers of their own t; the same knots under every rule, with the least
/// length, bending energy and curvature marked. None for incomplete curves.
[[nodiscard]] std::optional<std::vector<Table>> tablesOf(const SplineCurve& curve, WorkBudget& budget);

} // namespace kriva
