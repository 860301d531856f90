#pragma once

#include "core/geometry/box.h"

#include <QPointF>
#include <QSizeF>

namespace kriva::ui {

/// What part of the plane a canvas shows: a mapping in double between document units, y up, and the viewport's pixels,
/// y down. QGraphicsView's own scrolling counts in ints and loses far places at high zoom.
struct Viewport {
    double scale = 1;     ///< pixels per document unit
    Point centre;         ///< shown in the middle
    QSizeF size;          ///< in pixels
    double unitScale = 1; ///< pixels per document unit at 100 %
    friend bool operator==(const Viewport&, const Viewport&) = default;

    /// 1 at 100 %.
    [[nodiscard]] double zoom() const { return scale / unitScale; }
    /// Finite for every point within the model's limits, and then below 1e28.
    [[nodiscard]] QPointF toPixels(Point p) const {
        return {size.width() / 2 + (p.x - centre.x) * scale, size.height() / 2 - (p.y - centre.y) * scale};
    }
    /// Within the model's limits on numbers, whatever the pixel.
    [[nodiscard]] Point toDocument(QPointF pixel) const;
};

inline constexpr double kSmallestZoom = 1e-6;
inline constexpr double kLargestZoom = 1e9;

/// The same centre under another zoom, which is kept from kSmallestZoom to kLargestZoom.
[[nodiscard]] Viewport zoomedTo(Viewport viewport, double zoom);

/// What lies under the pixel stays there.
[[nodiscard]] Viewport zoomedAt(const Viewport& viewport, QPointF pixel, double factor);

/// Everything moves by `pixels`.
[[nodiscard]] Viewport panned(Viewport viewport, QPointF pixels);

/// The box in the middle and as large as fits with a margin in pixels on every side. A single point is shown at 100 %;
/// an empty box changes nothing.
[[nodiscard]] Viewport fitted(const Viewport& viewport, const Box& box, double margin);

/// Moved as little as needed to have the point in view, with a margin in pixels.
[[nodiscard]] Viewport revealing(const Viewport& viewport, Point p, double margin);

/// The part of the plane that is seen.
[[nodiscard]] Box visibleBox(const Viewport& viewport);

} // namespace kriva::ui
