#pragma once

#include "core/budget/work_budget.h"
#include "core/curve/table.h"
#include "core/sheets/elevation/elevation.h"

namespace kriva {

/// How the last elevation made each of its points: b_i' = i/N b_(i-1) + (1 - i/N) b_i with the actual numbers. Empty
/// where the degree is not raised.
[[nodiscard]] std::optional<std::vector<Table>> tablesOf(const ElevationCurve& curve, WorkBudget& budget);

} // namespace kriva
