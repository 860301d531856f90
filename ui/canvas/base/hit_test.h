#pragma once

#include "ui/canvas/base/selection.h"
#include "ui/canvas/base/viewport.h"

#include <QPolygonF>
#include <QRectF>

#include <span>
#include <vector>

namespace kriva::ui {

/// A curve as it can be taken hold of: by its grips, in document units, and by its polylines, in pixels; and its other
/// marks.
struct HitTarget {
    Serial serial = 0;
    bool isActive = false;
    std::span<const Grip> grips;
    std::span<const QPolygonF> lines;
    std::span<const Layer> layers = {};
};

inline constexpr double kGripReach = 10; ///< pixels
inline constexpr double kCurveReach = 6; ///< pixels

/// What a person means by this pixel. Grips within kGripReach win over curves; among them the nearest, and of those in
/// one place a selected one, then a knot before its retracted handle, then one of the active curve. Elsewhere the
/// nearest curve within kCurveReach, of equally near ones the active one, and the nearest mark within the same reach.
/// Linear in grips, marks and points of polylines.
[[nodiscard]] Hit hitAt(QPointF pixel, std::span<const HitTarget> targets, const Viewport& viewport,
                        const Selection& selection);

/// The points (no handles) inside a rectangle of pixels, its edge included.
[[nodiscard]] Selection pointsIn(const QRectF& rectangle, std::span<const HitTarget> targets, const Viewport& viewport);

} // namespace kriva::ui
