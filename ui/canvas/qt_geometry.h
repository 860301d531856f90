#pragma once

#include "core/figure/role_style.h"
#include "core/geometry/box.h"

#include <QColor>
#include <QPen>
#include <QPointF>

#include <algorithm>

/// Core's values in Qt's types, number by number: nothing is turned upside down.
namespace kriva::ui {

/// Points of print are shown at 96 logical pixels to the inch.
inline constexpr double kPixelsPerPoint = 96.0 / 72;

[[nodiscard]] inline QPointF toQt(Point p) {
    return {p.x, p.y};
}
[[nodiscard]] inline Point toCore(QPointF p) {
    return {p.x(), p.y()};
}
[[nodiscard]] inline QColor toQt(Color color) {
    return {color.red, color.green, color.blue};
}

/// The pen of a role's lines, in logical pixels.
[[nodiscard]] inline QPen toQt(const RoleStyle& style) {
    QPen pen(toQt(style.color), style.width * kPixelsPerPoint, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin);
    if (!style.dashes.empty() && style.width > 0) {
        QList<double> inWidths;
        for (const double length : style.dashes)
            inWidths.append(length / style.width);
        pen.setDashPattern(inWidths);
    }
    return pen;
}

} // namespace kriva::ui
