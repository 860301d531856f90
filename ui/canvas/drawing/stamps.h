#pragma once

#include "core/figure/role_style.h"
#include "ui/canvas/viewport.h"

#include <QPixmap>

#include <span>
#include <vector>

class QPainter;

namespace kriva::ui {

/// One small picture at many places. Both count in device pixels, so that painting is plain copying.
struct Stamps {
    QPixmap picture;
    std::vector<QPoint> places; ///< of the picture's top left corner
};

/// A mark in the middle of a picture that just holds it.
[[nodiscard]] QPixmap markPicture(const RoleStyle& style, double devicePixelRatio);

/// The picture centred on those of the points that are seen, once for each pixel however many points fall on it.
[[nodiscard]] Stamps stampsAt(std::span<const Point> points, QPixmap picture, const Viewport& viewport,
                              double devicePixelRatio);

void paint(QPainter& painter, const Stamps& stamps, double devicePixelRatio);

} // namespace kriva::ui
