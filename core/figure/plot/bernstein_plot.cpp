#include "core/figure/plot/bernstein_plot.h"

#include "core/figure/labels.h"

namespace kriva {

Plot bernsteinPlot(int degree, double t) {
    Plot plot{Caption::bernsteinPolynomials, {.variable = "t"}, {}, {}};
    for (int i = 0; i <= degree; ++i) {
        std::vector<double> coefficients(static_cast<std::size_t>(degree) + 1);
        coefficients[static_cast<std::size_t>(i)] = 1;
        plot.lines.push_back({graphPath(coefficients, 0, 1), Role::plotLine, i, Caption::none, "B", decimal(i)});
    }
    plot.at = t;
    return plot;
}

} // namespace kriva
