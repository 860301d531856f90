#pragma once

#include "core/budget/work_budget.h"
#include "core/geometry/box.h"

#include <cstddef>
#include <functional>

namespace kriva {

/// Calls `meet` once for each pair of boxes that overlap, the smaller index first, in no order, until the budget ends.
/// Sorted sweep along x: O(n log n) and the pairs whose ranges of x overlap.
void forEachOverlap(std::span<const Box> boxes, WorkBudget& budget,
                    const std::function<void(std::size_t, std::size_t)>& meet);

} // namespace kriva
