#pragma once

#include "core/budget/work_budget.h"
#include "core/curve/table.h"
#include "core/sheets/subdivision/subdivision.h"

namespace kriva {

/// De Casteljau's scheme at t, a column for each level; the weights of the control points at t; the two polygons that
/// the cut leaves; and, where the curve asks for it, the scheme of the blossom. None for incomplete curves.
[[nodiscard]] std::optional<std::vector<Table>> tablesOf(const SubdivisionCurve& curve, WorkBudget& budget);

} // namespace kriva
