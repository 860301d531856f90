#include "core/figure/plot/plot.h"

#include "core/bezier/bounds.h"
#include "core/bezier/clip.h"
#include "core/bezier/evaluate.h"
#include "core/polynomial/sign_changes.h"

#include <algorithm>
#include <limits>

namespace kriva {
namespace {

constexpr double kRoom = 0.05; ///< above and below the lines, in parts of their height

/// The box of what the lines have between the ends of the axis x.
Box seenBox(const Plot& plot) {
    constexpr double kFar = std::numeric_limits<double>::max();
    const Box strip{plot.x.low, -kFar, plot.x.high, kFar};
    Box box;
    for (const PlotLine& line : plot.lines)
        forEachPiece(line.path, [&](std::span<const Point> piece) {
            for (const Points& part : clipped(piece, strip))
                box = united(box, tightBounds(part));
        });
    for (const Point p : plot.given)
        if (plot.x.low <= p.x && p.x <= plot.x.high)
            extend(box, p);
    return box;
}

void fit(PlotAxis& axis, double low, double high) {
    if (axis.isLogarithmic) {
        // Whole powers of ten at the ends.
        axis.low = std::pow(10, std::floor(std::log10(low)));
        axis.high = std::max(10 * axis.low, std::pow(10, std::ceil(std::log10(high))));
        return;
    }
    const double room = high > low ? kRoom * (high - low) : 1;
    axis.low = low - room;
    axis.high = high + room;
}

} // namespace

double toLength(const PlotAxis& axis, double value) {
    return axis.isLogarithmic ? std::log10(value) : value;
}

double fromLength(const PlotAxis& axis, double length) {
    return axis.isLogarithmic ? std::pow(10, length) : length;
}

Plot withYFitted(Plot plot) {
    const Box box = seenBox(plot);
    if (!box.isEmpty())
        fit(plot.y, box.ymin, box.ymax);
    return plot;
}

Plot withAxesFitted(Plot plot) {
    Box box = boxOf(plot.given);
    for (const PlotLine& line : plot.lines)
        forEachPiece(line.path, [&](std::span<const Point> piece) { box = united(box, tightBounds(piece)); });
    if (box.isEmpty())
        return plot;
    fit(plot.x, box.xmin, box.xmax);
    fit(plot.y, box.ymin, box.ymax);
    return plot;
}

std::optional<double> valueAt(const PlotLine& line, double x) {
    std::optional<double> value;
    forEachPiece(line.path, [&](std::span<const Point> piece) {
        if (value)
            return;
        if (piece.front().x == x || piece.back().x == x) {
            value = piece.front().x == x ? piece.front().y : piece.back().y;
            return;
        }
        std::vector<double> distances;
        for (const Point p : piece)
            distances.push_back(p.x - x);
        if (const std::vector<double> changes = signChanges(distances); !changes.empty())
            value = evaluate(piece, changes.front()).y;
    });
    return value;
}

double lookedAt(const Plot& plot, double x) {
    if (!plot.isSequence || plot.lines.empty())
        return x;
    const double at = toLength(plot.x, x);
    return std::ranges::min(plot.lines.front().path.points, {},
                            [&](Point p) { return std::abs(toLength(plot.x, p.x) - at); })
        .x;
}

Path graphPath(std::span<const double> coefficients, double from, double to) {
    Points points;
    const double last = std::max(1.0, static_cast<double>(coefficients.size()) - 1);
    for (const double y : coefficients) {
        const double t = static_cast<double>(points.size()) / last;
        points.push_back({(1 - t) * from + t * to, y});
    }
    if (points.size() == 1) // a level line
        points.push_back({to, points.front().y});
    return singleCurve(points);
}

} // namespace kriva
