#include "core/figure/plot/bernstein_plot.h"
#include "core/sheets/elevation/elevation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kriva {
namespace {

/// As far as the elevations are looked at, where the curve has fewer.
constexpr int kUsualElevations = 97;
constexpr double kStep = 1.08; ///< from one degree of the plot to the next, at least

/// Some hundred numbers of elevations, close together at first; `asked` is one of them.
std::vector<int> plottedTimes(int degree, int most, int asked) {
    std::vector<int> plotted;
    for (double next = degree; next <= degree + most; next = std::max(next + 1, std::floor(next * kStep)))
        plotted.push_back(static_cast<int>(next) - degree);
    for (const int further : {asked, most})
        if (const auto at = std::ranges::lower_bound(plotted, further); at == plotted.end() || *at != further)
            plotted.insert(at, further);
    return plotted;
}

Plot gapPlot(const ElevationCurve& curve, WorkBudget& budget) {
    const int degree = static_cast<int>(curve.points.size()) - 1;
    Plot plot{Caption::gap, {.isLogarithmic = true, .variable = "N"}, {.isLogarithmic = true, .variable = "δ"}, {}};
    Points gaps;
    ElevationCurve raised = curve;
    for (const int times : plottedTimes(degree, std::max(kUsualElevations, curve.times), curve.times)) {
        if (!budget.spend())
            return plot;
        raised.times = times;
        // A straight curve with its points evenly spaced has no gap, and nothing has a logarithm of it.
        if (const double gap = elevate(raised).gap; gap > 0)
            gaps.push_back({static_cast<double>(degree + times), gap});
    }
    if (gaps.size() < 2)
        return plot;
    const double constant = gaps.back().x * gaps.back().y;
    Points reference;
    for (const Point gap : gaps)
        reference.push_back({gap.x, constant / gap.x});
    plot.lines.push_back({polyline(gaps), Role::plotLine, 0, Caption::none, "δ"});
    plot.lines.push_back({polyline(reference), Role::reference, 0, Caption::none, "c/N"});
    plot.isSequence = true;
    plot.at = degree + curve.times;
    return withAxesFitted(std::move(plot));
}

} // namespace

std::optional<std::vector<PlotGroup>> plotsOf(const ElevationCurve& curve, WorkBudget& budget) {
    if (isIncomplete(curve))
        return std::vector<PlotGroup>();
    constexpr double kMiddle = 0.5; // the curve is about no t of its own
    Plot gap = gapPlot(curve, budget);
    if (budget.end())
        return {};
    return {{{Caption::bernsteinPolynomials, {bernsteinPlot(static_cast<int>(curve.points.size()) - 1, kMiddle)}},
             {Caption::gap, {std::move(gap)}}}};
}

} // namespace kriva
