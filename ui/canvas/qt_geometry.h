#pragma once

#include "core/geometry/point.h"

#include <QPointF>

/// Core's geometry in Qt's types, number by number: nothing is turned upside down.
namespace kriva::ui {

/// Points of print are shown at 96 logical pixels to the inch.
inline constexpr double kPixelsPerInch = 96;
inline constexpr double kPixelsPerPoint = kPixelsPerInch / 72;
inline constexpr double kPixelsPerMillimetre = kPixelsPerInch / 25.4;

[[nodiscard]] inline QPointF toQt(Point p) {
    return {p.x, p.y};
}
[[nodiscard]] inline Point toCore(QPointF p) {
    return {p.x(), p.y()};
}

} // namespace kriva::ui
