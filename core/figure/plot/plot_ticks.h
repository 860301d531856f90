#pragma once

#include "core/figure/plot/plot.h"

namespace kriva {

/// A place on an axis with what stands beside it.
struct PlotTick {
    double at = 0;
    Label label; ///< not yet in its place
};

/// The ticks of an axis so many millimetres long, about so many apart: at 1, 2 or 5 times powers of ten, or at these
/// powers on a logarithmic axis. At least two, unless they would touch: one number alone gives no scale.
[[nodiscard]] std::vector<PlotTick> ticksOf(const PlotAxis& axis, double length, double spacing);

} // namespace kriva
