#include "ui/canvas/drawing/highlights.h"

#include <QPainter>

namespace kriva::ui {
namespace {

// In points, and larger than any mark of a figure.
constexpr double kSelectedSize = 6;
constexpr double kHoveredSize = 8.5;
constexpr double kOutline = 1.2;

constexpr float kBandOpacity = 0.15F;

constexpr double kGhostRadius = 4.5; // pixels
constexpr double kGhostOpacity = 0.6;

[[nodiscard]] Color toCore(const QColor& color) {
    return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
            static_cast<std::uint8_t>(color.blue())};
}

} // namespace

std::vector<Stamps> highlights(std::span<const Point> selected, std::optional<Point> hovered,
                               const HighlightColors& colors, const Viewport& viewport, double devicePixelRatio) {
    const Color accent = toCore(colors.accent);
    const RoleStyle disc{toCore(colors.ink), 0, {}, Marker::circle, kSelectedSize, kOutline, accent};
    const RoleStyle ring{accent, 0, {}, Marker::ring, kHoveredSize, kOutline, {}};
    const auto marks = [&](const RoleStyle& style, std::span<const Point> points) {
        return stampsAt(points, markPicture(style, devicePixelRatio), viewport, devicePixelRatio);
    };
    std::vector<Stamps> stamps{marks(disc, selected)};
    if (hovered)
        stamps.push_back(marks(ring, {&*hovered, 1}));
    return stamps;
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
