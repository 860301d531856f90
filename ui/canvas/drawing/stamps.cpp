#include "ui/canvas/drawing/stamps.h"

#include "ui/canvas/qt_geometry.h"
#include "ui/figures/figure_ink.h"

#include <QPainter>

#include <cmath>

namespace kriva::ui {
namespace {

// More marks than this stand so thick that those on the same few pixels are left out.
constexpr std::size_t kMostStamps = 20'000;
constexpr int kThickestCell = 8;

/// The middles of the marks that are seen, in device pixels; of those in the same cell the first.
[[nodiscard]] std::vector<QPoint> seenPixels(std::span<const Point> points, const Viewport& viewport,
                                             double devicePixelRatio, double margin, int cell) {
    const double right = viewport.size.width() * devicePixelRatio + margin;
    const double bottom = viewport.size.height() * devicePixelRatio + margin;
    const auto columns = static_cast<std::size_t>((right + margin) / cell) + 1;
    const auto rows = static_cast<std::size_t>((bottom + margin) / cell) + 1;
    std::vector<bool> isTaken(columns * rows);
    std::vector<QPoint> seen;
    for (const Point p : points) {
        const QPointF pixel = viewport.toPixels(p) * devicePixelRatio;
        if (!(pixel.x() >= -margin && pixel.x() <= right && pixel.y() >= -margin && pixel.y() <= bottom))
            continue;
        const auto column = static_cast<std::size_t>((pixel.x() + margin) / cell);
        const auto row = static_cast<std::size_t>((pixel.y() + margin) / cell);
        if (isTaken[row * columns + column])
            continue;
        isTaken[row * columns + column] = true;
        seen.push_back(pixel.toPoint());
    }
    return seen;
}

} // namespace

QPixmap markPicture(const RoleStyle& style, double devicePixelRatio) {
    const double scale = kPixelsPerPoint * devicePixelRatio;
    // An odd side has a pixel in its middle; two more leave room for antialiasing.
    const int side = 2 * static_cast<int>(std::ceil((style.markerSize + style.markerWidth) * scale / 2)) + 3;
    QPixmap picture(side, side);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    paintMark(painter, style, {side / 2.0, side / 2.0}, scale);
    return picture;
}

Stamps stampsAt(std::span<const Point> points, QPixmap picture, const Viewport& viewport, double devicePixelRatio) {
    Stamps stamps{std::move(picture), {}};
    const QPoint middle(stamps.picture.width() / 2, stamps.picture.height() / 2);
    for (int cell = 1; cell <= kThickestCell; cell *= 2) {
        stamps.places = seenPixels(points, viewport, devicePixelRatio, middle.x(), cell);
        if (stamps.places.size() <= kMostStamps)
            break;
    }
    for (QPoint& place : stamps.places)
        place -= middle;
    return stamps;
}

void paint(QPainter& painter, const Stamps& stamps, double devicePixelRatio) {
    painter.save();
    painter.scale(1 / devicePixelRatio, 1 / devicePixelRatio);
    for (const QPoint place : stamps.places)
        painter.drawPixmap(place, stamps.picture);
    painter.restore();
}

} // namespace kriva::ui
