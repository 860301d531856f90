#include "core/figure/plot/bernstein_plot.h"
#include "core/sheets/subdivision/subdivision.h"

namespace kriva {

std::optional<std::vector<PlotGroup>> plotsOf(const SubdivisionCurve& curve, WorkBudget& budget) {
    if (isIncomplete(curve))
        return std::vector<PlotGroup>();
    if (!budget.spend())
        return {};
    const int degree = static_cast<int>(controlPointCount(curve)) - 1;
    return {{{Caption::bernsteinPolynomials, {bernsteinPlot(degree, curve.t)}}}};
}

} // namespace kriva
