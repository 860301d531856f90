#pragma once

#include "core/geometry/box.h"

#include <QPointF>
#include <QRectF>

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
[[nodiscard]] inline Box boxOf(std::span<const QPointF> points) {
    Box box;
    for (const QPointF p : points)
        extend(box, toCore(p));
    return box;
}
[[nodiscard]] inline QRectF toQt(const Box& box) {
    return box.isEmpty() ? QRectF() : QRectF(box.xmin, box.ymin, box.width(), box.height());
}
[[nodiscard]] inline Box toCore(const QRectF& rectangle) {
    return {rectangle.left(), rectangle.top(), rectangle.right(), rectangle.bottom()};
}

} // namespace kriva::ui
