#include "core/figure/plot/plot_figure.h"

#include "core/bezier/clip.h"
#include "core/figure/plot/plot_ticks.h"

#include <algorithm>
#include <array>

namespace kriva {
namespace {

// Room around the frame, in millimetres.
constexpr double kLeft = 13;   ///< for the numbers of y
constexpr double kBelow = 8;   ///< for those of x
constexpr double kBeside = 4;  ///< for half of the last number of x
constexpr double kLegend = 28; ///< a sample of the line and a word with a number

// Between neighbouring numbers, in millimetres.
constexpr double kSpacingX = 14;
constexpr double kSpacingY = 9;

constexpr std::size_t kMostEntries = 16; ///< of the legend: more would not fit
constexpr double kEntryHeight = 4.6;
constexpr double kLeastEntryHeight = 3.4; ///< lines of text that do not touch
constexpr double kSampleLength = 6;

constexpr std::string_view kGrid = "plot-grid";
constexpr std::string_view kNumbers = "plot-numbers";
constexpr std::string_view kAxes = "plot-axes";
constexpr std::string_view kLines = "plot-lines";
constexpr std::string_view kGiven = "plot-given";
constexpr std::string_view kAt = "plot-at";
constexpr std::string_view kLegendLayer = "plot-legend";

constexpr std::array kLayers{
    LayerInfo{kGrid, translatable("Caption", "Grid")},
    LayerInfo{kNumbers, translatable("Caption", "Numbers of the axes")},
    LayerInfo{kAxes, translatable("Caption", "Axes")},
    LayerInfo{kLines, translatable("Caption", "Lines")},
    LayerInfo{kGiven, Caption::points},
    LayerInfo{kAt, translatable("Caption", "Place on view")},
    LayerInfo{kLegendLayer, translatable("Caption", "Legend")},
};

bool hasName(const PlotLine& line) {
    return line.caption != Caption::none || !line.letter.empty();
}

bool hasLegend(const Plot& plot) {
    return plot.lines.size() <= kMostEntries && std::ranges::any_of(plot.lines, hasName);
}

/// From 0 to 1 between the ends of an axis.
double along(const PlotAxis& axis, double value) {
    const double low = toLength(axis, axis.low);
    return (toLength(axis, value) - low) / (toLength(axis, axis.high) - low);
}

/// The value at a part of the way between the ends of an axis.
double valueAlong(const PlotAxis& axis, double part) {
    const double low = toLength(axis, axis.low);
    return fromLength(axis, low + part * (toLength(axis, axis.high) - low));
}

void addLine(Layer& layer, Point from, Point to, Role role) {
    const Points line{from, to};
    layer.strokes.push_back({polyline(line), role});
}

/// The layer of that name, on top of the others where it is not there yet: plots share their layers.
Layer& layerOf(Figure& figure, std::string_view name) {
    const auto found = std::ranges::find(figure.layers, name, &Layer::name);
    return found == figure.layers.end() ? figure.layers.emplace_back(Layer{name}) : *found;
}

/// Grid and numbers of both axes, and their variables at the ends.
void addTicks(const PlotAxis& axis, bool isX, const Box& frame, Figure& figure) {
    for (PlotTick& tick : ticksOf(axis, isX ? frame.width() : frame.height(), isX ? kSpacingX : kSpacingY)) {
        const double part = along(axis, tick.at);
        const Point from = isX ? Point{frame.xmin + part * frame.width(), frame.ymin}
                               : Point{frame.xmin, frame.ymin + part * frame.height()};
        addLine(layerOf(figure, kGrid), from, isX ? Point{from.x, frame.ymax} : Point{frame.xmax, from.y},
                Role::gridLine);
        tick.label.at = from;
        tick.label.side = isX ? LabelSide::below : LabelSide::left;
        layerOf(figure, kNumbers).labels.push_back(std::move(tick.label));
    }
}

void addAxes(const Plot& plot, const Box& frame, Figure& figure) {
    layerOf(figure, kGrid); // below everything
    addTicks(plot.x, true, frame, figure);
    addTicks(plot.y, false, frame, figure);
    Layer& axes = layerOf(figure, kAxes);
    addLine(axes, {frame.xmin, frame.ymin}, {frame.xmax, frame.ymin}, Role::axis);
    addLine(axes, {frame.xmin, frame.ymin}, {frame.xmin, frame.ymax}, Role::axis);
    Label x{{frame.xmax, frame.ymin}, Caption::none, plot.x.variable, ""};
    x.side = LabelSide::right;
    Label y{{frame.xmin, frame.ymax}, Caption::none, plot.y.variable, ""};
    y.side = LabelSide::above;
    axes.labels.insert(axes.labels.end(), {x, y});
}

void addLines(const Plot& plot, const Box& frame, Figure& figure) {
    Layer& lines = layerOf(figure, kLines);
    for (const PlotLine& line : plot.lines) {
        std::vector<Points> joined;
        const auto finish = [&] {
            if (!joined.empty())
                lines.strokes.push_back({chain(joined, false), line.role, line.series});
            joined.clear();
        };
        forEachPiece(line.path, [&](std::span<const Point> piece) {
            Points mapped;
            for (const Point p : piece)
                mapped.push_back(onPlot(plot, frame, p));
            for (Points& part : clipped(mapped, frame)) {
                if (!joined.empty() && joined.back().back() != part.front())
                    finish();
                joined.push_back(std::move(part));
            }
        });
        finish();
    }
}

/// Where the lines are at the place that the plot is about.
void addMarks(const Plot& plot, const Box& frame, Figure& figure) {
    if (!plot.at || *plot.at < plot.x.low || *plot.at > plot.x.high)
        return;
    Layer& layer = layerOf(figure, kAt);
    const double x = onPlot(plot, frame, {*plot.at, plot.y.low}).x;
    addLine(layer, {x, frame.ymin}, {x, frame.ymax}, Role::axis);
    Marks marks{{}, Role::plotMark};
    for (const PlotLine& line : plot.lines)
        if (const std::optional<double> y = line.role == Role::reference ? std::nullopt : valueAt(line, *plot.at))
            if (const Point p = onPlot(plot, frame, {*plot.at, *y}); p.y >= frame.ymin && p.y <= frame.ymax)
                marks.at.push_back(p);
    layer.marks.push_back(std::move(marks));
}

void addGiven(const Plot& plot, const Box& frame, Figure& figure) {
    Marks marks{{}, Role::point};
    for (const Point p : plot.given)
        if (const Point mapped = onPlot(plot, frame, p); mapped.x >= frame.xmin && mapped.x <= frame.xmax)
            marks.at.push_back(mapped);
    if (!marks.at.empty())
        layerOf(figure, kGiven).marks.push_back(std::move(marks));
}

/// As far apart as they like, closer together where the plot is low; what then has no room is left out.
void addLegend(const Plot& plot, const Box& frame, double bottom, double top, Figure& figure) {
    if (!hasLegend(plot))
        return;
    Layer& layer = layerOf(figure, kLegendLayer);
    const auto entries = static_cast<double>(std::ranges::count_if(plot.lines, hasName));
    const double step = std::clamp((top - bottom) / entries, kLeastEntryHeight, kEntryHeight);
    const bool isBesideFrame = frame.ymax - entries * step >= bottom;
    Point at{frame.xmax + kBeside, (isBesideFrame ? std::min(top, frame.ymax) : top) - step / 2};
    for (const PlotLine& line : plot.lines) {
        if (!hasName(line))
            continue;
        if (at.y - step / 2 < bottom)
            break;
        const Points sample{at, at + Vector{kSampleLength, 0}};
        layer.strokes.push_back({polyline(sample), line.role, line.series});
        Label label{sample.back(), line.caption, line.letter, line.index};
        label.side = LabelSide::right;
        layer.labels.push_back(std::move(label));
        at = at - Vector{0, step};
    }
}

/// Between these heights, its frame among them.
void addPlot(const Plot& plot, const Box& frame, double bottom, double top, Figure& figure) {
    addAxes(plot, frame, figure);
    addLines(plot, frame, figure);
    addGiven(plot, frame, figure);
    addMarks(plot, frame, figure);
    addLegend(plot, frame, bottom, top, figure);
}

} // namespace

std::span<const LayerInfo> plotLayers() {
    return kLayers;
}

Box plotFrame(const Plot& plot, PlotSize size) {
    constexpr double kLeast = 10; // of a frame that has hardly any room
    const double right = size.width - (hasLegend(plot) ? kLegend : 2 * kBeside);
    Box frame{kLeft, kBelow, std::max(kLeft + kLeast, right), std::max(kBelow + kLeast, size.height - kBelow)};
    if (!plot.isToScale)
        return frame;
    const double scale =
        std::min(frame.width() / (plot.x.high - plot.x.low), frame.height() / (plot.y.high - plot.y.low));
    const Point middle = frame.centre();
    const Vector half = scale / 2 * Vector{plot.x.high - plot.x.low, plot.y.high - plot.y.low};
    return {middle.x - half.x, middle.y - half.y, middle.x + half.x, middle.y + half.y};
}

Point onPlot(const Plot& plot, const Box& frame, Point p) {
    return {frame.xmin + along(plot.x, p.x) * frame.width(), frame.ymin + along(plot.y, p.y) * frame.height()};
}

Point inPlot(const Plot& plot, const Box& frame, Point millimetres) {
    return {valueAlong(plot.x, (millimetres.x - frame.xmin) / frame.width()),
            valueAlong(plot.y, (millimetres.y - frame.ymin) / frame.height())};
}

Figure plotFigure(std::span<const Plot> plots, PlotSize size) {
    Figure figure;
    double above = size.height * static_cast<double>(plots.size());
    for (const Plot& plot : plots) {
        above -= size.height;
        Box frame = plotFrame(plot, size);
        frame.ymin += above;
        frame.ymax += above;
        addPlot(plot, frame, above, above + size.height, figure);
    }
    return figure;
}

Page plotPage(std::size_t count, PlotSize size, double margin) {
    const Box box{0, 0, size.width, size.height * static_cast<double>(count)};
    return pageOf(box, 1, margin);
}

} // namespace kriva
