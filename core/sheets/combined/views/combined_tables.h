#pragma once

#include "core/budget/work_budget.h"
#include "core/curve/table.h"
#include "core/sheets/combined/combined_curve.h"

namespace kriva {

/// The runs with their polynomials in the chosen basis and their residuals; the joins with their control points. None
/// for incomplete curves.
[[nodiscard]] std::optional<std::vector<Table>> tablesOf(const CombinedCurve& curve, WorkBudget& budget);

} // namespace kriva
