#pragma once

#include "core/figure/text_source.h"
#include "core/figure/ticks.h"
#include "ui/canvas/base/viewport.h"

#include <QColor>
#include <QFont>

class QPainter;

namespace kriva::ui {

/// What of the background is shown, and in which colours.
struct GridLook {
    bool hasGrid = true;
    bool hasAxes = true;
    QColor ink;
    QColor paper;
    QFont font;
};

/// The distance of the grid's lines in document units: 1, 2 or 5 times a power of ten, so that they are at least
/// kGridSpacing pixels apart. Also the way of one arrow key.
[[nodiscard]] double gridStep(const Viewport& viewport);
inline constexpr double kGridSpacing = 16;

/// The distance of the stronger lines, which have numbers: likewise, a multiple of gridStep().
[[nodiscard]] double numberStep(const Viewport& viewport);
/// The multiple of `step` nearest to the number, as it is read: three steps of 0.1 are 0.3.
[[nodiscard]] double nearestMultiple(double step, double number);

/// Lines, the two axes and their numbers, which stay at the edge where the axis itself is out of sight.
void paintGrid(QPainter& painter, const Viewport& viewport, const GridLook& look, const TextSource& texts);

} // namespace kriva::ui
