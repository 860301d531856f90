#pragma once

#include "core/crossings/contacts/arc.h"

namespace kriva {

/// The arc's own parameter at the end of the perpendicular from a place close to it, near a known one.
[[nodiscard]] double foot(const Arc& arc, Point place, double t);

/// The parameters of the segment, ascending, where the arc passes a place within the gap, once for each pass.
[[nodiscard]] std::vector<double> passagesThrough(const Arc& arc, Point place, double gap);

} // namespace kriva
