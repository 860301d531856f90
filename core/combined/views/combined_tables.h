#pragma once

#include "core/combined/combined_curve.h"
#include "core/document/table.h"
#include "core/work/work_budget.h"

namespace kriva {

/// The runs with their polynomials in the chosen basis and their residuals; the joins with their control points. None
/// for incomplete curves.
[[nodiscard]] std::optional<std::vector<Table>> tablesOf(const CombinedCurve& curve, WorkBudget& budget);

} // namespace kriva
