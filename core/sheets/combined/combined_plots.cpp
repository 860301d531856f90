#include "core/bezier/evaluate.h"
#include "core/curve/limits.h"
#include "core/figure/labels.h"
#include "core/sheets/combined/combined.h"

#include <algorithm>
#include <utility>

namespace kriva {
namespace {

using Method = CombinedCurve::Method;

/// The slopes y' along a part of a run, as a graph over x: its x run evenly.
Points slopeGraph(std::span<const Point> part) {
    const double width = part.back().x - part.front().x;
    const std::vector<Vector> velocities = hodograph(part);
    Points slopes;
    for (const Vector v : velocities) {
        const double t = velocities.size() == 1
                             ? 0
                             : static_cast<double>(slopes.size()) / static_cast<double>(velocities.size() - 1);
        slopes.push_back({part.front().x + t * width, v.y / width});
    }
    if (slopes.size() == 1)
        slopes.push_back({part.back().x, slopes.front().y});
    return slopes;
}

template <class Graph>
Plot plotOf(Caption caption, std::string variable, const Combined& combined, Graph graph) {
    Plot plot{caption, {.variable = "x"}, {.variable = std::move(variable)}, {}};
    for (std::size_t i = 0; i < combined.runs.size(); ++i) {
        std::vector<Points> parts;
        for (const Points& part : combined.runs[i].parts)
            parts.push_back(graph(part));
        const int number = static_cast<int>(i);
        if (!parts.empty())
            plot.lines.push_back({chain(parts, false), Role::run, number, Caption::run, decimal(number)});
    }
    return plot;
}

bool canInterpolate(const CombinedCurve& curve) {
    return std::ranges::all_of(monotoneRuns(curve.points),
                               [](const MonotoneRun& run) { return run.size() <= limits::kControlPoints; });
}

/// Both plots show the same x.
void shareX(PlotGroup& group) {
    PlotAxis x = group.plots.front().x;
    for (const Plot& plot : group.plots) {
        x.low = std::min(x.low, plot.x.low);
        x.high = std::max(x.high, plot.x.high);
    }
    for (Plot& plot : group.plots)
        plot.x = x;
}

} // namespace

std::optional<std::vector<PlotGroup>> plotsOf(const CombinedCurve& curve, WorkBudget& budget) {
    if (isIncomplete(curve))
        return std::vector<PlotGroup>();
    PlotGroup values{translatable("Caption", "Values of the runs, y(x)"), {}};
    PlotGroup slopes{translatable("Caption", "Slopes of the runs, y′(x)"), {}};
    const auto add = [&](Method method, Caption caption) {
        CombinedCurve other = curve;
        other.method = method;
        const std::optional<Combined> combined = combine(other, budget);
        if (!combined)
            return;
        Plot value = plotOf(caption, "y", *combined, [](const Points& part) { return part; });
        value.given = curve.points;
        values.plots.push_back(withAxesFitted(std::move(value)));
        slopes.plots.push_back(withAxesFitted(plotOf(caption, "y′", *combined, slopeGraph)));
    };
    if (canInterpolate(curve))
        add(Method::interpolation, Caption::interpolation);
    add(Method::approximation, Caption::approximation);
    if (budget.end())
        return {};
    shareX(values);
    shareX(slopes);
    return {{std::move(values), std::move(slopes)}};
}

} // namespace kriva
