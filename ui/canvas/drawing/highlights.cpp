#include "ui/canvas/drawing/highlights.h"

#include "ui/canvas/drawing/frame_load.h"

#include <QPainter>

namespace kriva::ui {
namespace {

// In points, and larger than any mark of a figure.
constexpr double kSelectedSize = 6;
constexpr double kHoveredSize = 8.5;
constexpr double kPointedOutSize = 14;
constexpr double kPointedOutline = 2;
constexpr double kOutline = 1.2;

constexpr double kSnapMarkReach = 11; // pixels: outside of the mark of the point itself
constexpr double kSnapWidth = 1.5;

constexpr float kBandOpacity = 0.15F;

constexpr double kGhostRadius = 4.5; // pixels
constexpr double kGhostOpacity = 0.6;

[[nodiscard]] Color toCore(const QColor& color) {
    return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
            static_cast<std::uint8_t>(color.blue())};
}

} // namespace

std::vector<Stamps> highlights(std::span<const Point> selected, std::optional<Point> hovered,
                               std::span<const Point> pointedOut, const HighlightColors& colors, StampView view) {
    const Color accent = toCore(colors.accent);
    const RoleStyle disc{toCore(colors.ink), 0, {}, Marker::circle, kSelectedSize, kOutline, accent};
    const RoleStyle ring{accent, 0, {}, Marker::ring, kHoveredSize, kOutline, {}};
    const RoleStyle wideRing{accent, 0, {}, Marker::ring, kPointedOutSize, kPointedOutline, {}};
    std::vector<Stamps> stamps;
    if (!pointedOut.empty())
        stamps.push_back(stampsAt(pointedOut, markPicture(wideRing, view.devicePixelRatio), view));
    if (hovered)
        stamps.push_back(stampsAt({&*hovered, 1}, markPicture(ring, view.devicePixelRatio), view));
    view.most = FrameLoad::kMarks;
    Stamps discs = stampsAt(selected, markPicture(disc, view.devicePixelRatio), view);
    for (; static_cast<double>(discs.places.size()) > view.most; view.spacing *= 2)
        discs = stampsAt(selected, discs.picture, view);
    stamps.insert(stamps.begin(), std::move(discs));
    return stamps;
}

void paintSnap(QPainter& painter, const Snap& snap, const HighlightColors& colors, const Viewport& viewport) {
    const QPointF at = viewport.toPixels(snap.at);
    painter.setPen(QPen(colors.accent, kSnapWidth));
    painter.setBrush(Qt::NoBrush);
    const QPointF right(kSnapMarkReach, 0);
    const QPointF down(0, kSnapMarkReach);
    switch (snap.kind) {
    case SnapKind::point:
        painter.drawRect(QRectF(at - right - down, at + right + down));
        break;
    case SnapKind::curve:
        painter.drawLine(at - right - down, at + right + down);
        painter.drawLine(at - right + down, at + right - down);
        break;
    case SnapKind::grid:
        painter.drawLine(at - right, at + right);
        painter.drawLine(at - down, at + down);
        break;
    }
}

void paintGhost(QPainter& painter, QPointF at, const HighlightColors& colors) {
    painter.save();
    painter.setOpacity(kGhostOpacity);
    painter.setPen(colors.ink);
    painter.setBrush(colors.accent);
    painter.drawEllipse(at, kGhostRadius, kGhostRadius);
    painter.restore();
}

void paintRubberBand(QPainter& painter, const QRectF& band, const HighlightColors& colors) {
    QColor fill = colors.accent;
    fill.setAlphaF(kBandOpacity);
    painter.setPen(colors.accent);
    painter.setBrush(fill);
    painter.drawRect(band);
}

} // namespace kriva::ui
