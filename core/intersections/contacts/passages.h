#pragma once

#include "core/budget/work_budget.h"
#include "core/intersections/contacts/arc.h"

namespace kriva {

/// A parameter this close to an end is the end.
inline constexpr double kAtEnd = 1e-10;

/// The arc's own parameter at the end of the perpendicular from a place close to it, near a known one.
[[nodiscard]] double foot(const Arc& arc, Point place, double t);

/// The parameters of the segment, ascending, where the arc passes a place within the gap, once for each pass.
[[nodiscard]] std::vector<double> passagesThrough(const Arc& arc, Point place, double gap, WorkBudget& budget);

/// Whether two arcs stay as close as `touching` between two of their contacts.
[[nodiscard]] bool touchBetween(const Arc& a, const Arc& b, Contact one, Contact other, double touching,
                                WorkBudget& budget);

} // namespace kriva
