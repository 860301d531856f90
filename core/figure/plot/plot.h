#pragma once

#include "core/figure/figure.h"

/// Diagrams as plain values, in the numbers that they are about; plotFigure() draws them.
namespace kriva {

/// What is seen along one axis.
struct PlotAxis {
    double low = 0; ///< positive on a logarithmic axis
    double high = 1;
    bool isLogarithmic = false;
    std::string variable = {}; ///< "t": the same in every language
    friend bool operator==(const PlotAxis&, const PlotAxis&) = default;
};

/// A value as a length along its axis, from anywhere in any unit, and back: the logarithm where the axis has it.
[[nodiscard]] double toLength(const PlotAxis& axis, double value);
[[nodiscard]] double fromLength(const PlotAxis& axis, double length);

/// A line over both axes, and what stands in the legend: a caption or a letter with an index.
struct PlotLine {
    Path path; ///< on logarithmic axes polylines alone
    Role role = Role::plotLine;
    int series = 0;
    Caption caption = Caption::none;
    std::string letter = {};
    std::string index = {};
    friend bool operator==(const PlotLine&, const PlotLine&) = default;
};

struct Plot {
    Caption caption = Caption::none;
    PlotAxis x;
    PlotAxis y;
    std::vector<PlotLine> lines;
    Points given = {};             ///< places that lines pass through or near
    std::optional<double> at = {}; ///< the x that the plot is about: the t of a curve
    bool isToScale = false;        ///< units of both axes are equally long
    bool isSequence = false;       ///< lines join the members of sequences: between them there is nothing
    friend bool operator==(const Plot&, const Plot&) = default;
};

/// Plots of one x, one above the other.
struct PlotGroup {
    Caption caption = Caption::none;
    std::vector<Plot> plots;
    friend bool operator==(const PlotGroup&, const PlotGroup&) = default;
};

/// The plot with an axis y that shows all lines and given places between the ends of the axis x, and a little room;
/// where they are level, one unit above and below.
[[nodiscard]] Plot withYFitted(Plot plot);

/// The plot with axes that show all lines and given places.
[[nodiscard]] Plot withAxesFitted(Plot plot);

/// The y of a line at an x; nothing where it is not there, the first along the line where it is there more than once.
[[nodiscard]] std::optional<double> valueAt(const PlotLine& line, double x);

/// The x nearest to that one at which the plot can be looked at: in sequences that of a member of the first line.
[[nodiscard]] double lookedAt(const Plot& plot, double x);

/// A polynomial with these Bernstein coefficients over x from `from` to `to`, as a line.
[[nodiscard]] Path graphPath(std::span<const double> coefficients, double from, double to);

} // namespace kriva
