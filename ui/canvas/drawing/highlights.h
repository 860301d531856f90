#pragma once

#include "ui/canvas/base/snapping.h"
#include "ui/canvas/drawing/stamps.h"

#include <QColor>

#include <optional>

namespace kriva::ui {

struct HighlightColors {
    QColor accent;
    QColor ink;
};

/// The marks over selected grips; over the one under the pointer, larger and hollow; and around places that are pointed
/// out, larger still: they differ without colour.
[[nodiscard]] std::vector<Stamps> highlights(std::span<const Point> selected, std::optional<Point> hovered,
                                             std::span<const Point> pointedOut, const HighlightColors& colors,
                                             StampView view);

/// A small mark around the place that a dragged point snapped to: a square on a point, a cross over a curve, a plus on
/// the grid.
void paintSnap(QPainter& painter, const Snap& snap, const HighlightColors& colors, const Viewport& viewport);

/// The dot where a point would be inserted, in pixels.
void paintGhost(QPainter& painter, QPointF at, const HighlightColors& colors);

/// How far from their places these two paint, at most, in pixels.
inline constexpr double kPlaceReach = 14;

/// The rectangle in which points are being selected, in pixels.
void paintRubberBand(QPainter& painter, const QRectF& band, const HighlightColors& colors);

} // namespace kriva::ui
