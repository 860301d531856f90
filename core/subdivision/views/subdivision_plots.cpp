#include "core/subdivision/views/subdivision_plots.h"

#include "core/figure/plot/bernstein_plot.h"

namespace kriva {

std::vector<PlotGroup> plotsOf(const SubdivisionCurve& curve) {
    if (isIncomplete(curve))
        return {};
    return {{Caption::bernsteinPolynomials, {bernsteinPlot(static_cast<int>(controlPointCount(curve)) - 1, curve.t)}}};
}

} // namespace kriva
