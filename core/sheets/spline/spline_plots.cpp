#include "core/bezier/evaluate.h"
#include "core/sheets/spline/spline.h"

namespace kriva {

std::optional<std::vector<PlotGroup>> plotsOf(const SplineCurve& curve, WorkBudget& budget) {
    if (isIncomplete(curve))
        return std::vector<PlotGroup>();
    Plot plot{Caption::hodograph, {.variable = "x′"}, {.variable = "y′"}, {}};
    plot.isToScale = true;
    for (const Points& segment : segmentsOf(curve)) {
        if (!budget.spend())
            return {};
        Points velocities;
        for (const Vector v : hodograph(segment))
            velocities.push_back(Point{} + v);
        plot.lines.push_back({singleCurve(velocities), Role::curve});
    }
    return {{{Caption::hodograph, {withAxesFitted(std::move(plot))}}}};
}

} // namespace kriva
