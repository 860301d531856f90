#pragma once

#include "core/figure/plot/plot.h"
#include "core/figure/style/page.h"

namespace kriva {

/// How large a plot is drawn, with its numbers and legend, in millimetres.
struct PlotSize {
    double width = 120;
    double height = 75;
    friend bool operator==(const PlotSize&, const PlotSize&) = default;
};

/// The layers of the figure of plots.
[[nodiscard]] std::span<const LayerInfo> plotLayers();

/// What of the page lies between the axes: x to the right and y up from the page's lower left corner, in millimetres.
[[nodiscard]] Box plotFrame(const Plot& plot, PlotSize size);

/// A place of the plot on the page, in the same coordinates, and back.
[[nodiscard]] Point onPlot(const Plot& plot, const Box& frame, Point p);
[[nodiscard]] Point inPlot(const Plot& plot, const Box& frame, Point millimetres);

/// Plots as a figure in these coordinates, the first one at the top: a grid with numbers, lines cut off at the frame, a
/// legend where lines have names, and marks where the lines are at the place that the plot is about.
[[nodiscard]] Figure plotFigure(std::span<const Plot> plots, PlotSize size);

/// The page of so many plots, with so much room around them.
[[nodiscard]] Page plotPage(std::size_t count, PlotSize size, double margin);

} // namespace kriva
