#pragma once

#include "core/crossings/arc.h"

namespace kriva {

/// The parameters of the segment, ascending, where the arc passes a place within the gap, once for each pass.
[[nodiscard]] std::vector<double> passagesThrough(const Arc& arc, Point place, double gap);

} // namespace kriva
