#include "ui/canvas/base/viewport.h"

#include "core/curve/limits.h"

#include <algorithm>

namespace kriva::ui {
namespace {

// Keeps pixels finite, with room to square them, whatever unitScale a figure of one point or of 1e9 units leads to.
constexpr double kSmallestScale = 1e-15;
constexpr double kLargestScale = 1e18;

[[nodiscard]] double withinLimits(double coordinate) {
    return std::clamp(coordinate, -limits::kNumber, limits::kNumber);
}
[[nodiscard]] Point withinLimits(Point p) {
    return {withinLimits(p.x), withinLimits(p.y)};
}

/// How far to move a pixel to have it between `low` and `high`.
[[nodiscard]] double wayInto(double pixel, double low, double high) {
    return low <= high ? std::clamp(pixel, low, high) - pixel : 0;
}

} // namespace

Point Viewport::toDocument(QPointF pixel) const {
    return withinLimits(
        Point{centre.x + (pixel.x() - size.width() / 2) / scale, centre.y - (pixel.y() - size.height() / 2) / scale});
}

Viewport zoomedTo(Viewport viewport, double zoom) {
    const double scale = std::clamp(zoom, kSmallestZoom, kLargestZoom) * viewport.unitScale;
    viewport.scale = std::clamp(scale, kSmallestScale, kLargestScale);
    return viewport;
}

Viewport zoomedAt(const Viewport& viewport, QPointF pixel, double factor) {
    Viewport result = zoomedTo(viewport, viewport.zoom() * factor);
    const QPointF fromMiddle = pixel - QPointF(viewport.size.width(), viewport.size.height()) / 2;
    const double shrink = 1 / viewport.scale - 1 / result.scale;
    result.centre = withinLimits(viewport.centre + Vector{fromMiddle.x(), -fromMiddle.y()} * shrink);
    return result;
}

Viewport panned(Viewport viewport, QPointF pixels) {
    viewport.centre = withinLimits(viewport.centre - Vector{pixels.x(), -pixels.y()} / viewport.scale);
    return viewport;
}

Viewport fitted(const Viewport& viewport, const Box& box, double margin) {
    if (box.isEmpty())
        return viewport;
    Viewport result = zoomedTo(viewport, 1);
    result.centre = withinLimits(box.centre());
    const double width = std::max(1.0, viewport.size.width() - 2 * margin);
    const double height = std::max(1.0, viewport.size.height() - 2 * margin);
    if (box.width() > 0 || box.height() > 0)
        result = zoomedTo(result, std::min(width / box.width(), height / box.height()) / viewport.unitScale);
    return result;
}

Viewport revealing(const Viewport& viewport, Point p, double margin) {
    const QPointF pixel = viewport.toPixels(p);
    const QPointF way(wayInto(pixel.x(), margin, viewport.size.width() - margin),
                      wayInto(pixel.y(), margin, viewport.size.height() - margin));
    return way.isNull() ? viewport : panned(viewport, way);
}

Box visibleBox(const Viewport& viewport) {
    Box box;
    extend(box, viewport.toDocument({0, 0}));
    extend(box, viewport.toDocument({viewport.size.width(), viewport.size.height()}));
    return box;
}

} // namespace kriva::ui
