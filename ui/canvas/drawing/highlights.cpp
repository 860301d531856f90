#include "ui/canvas/drawing/highlights.h"

#include "ui/canvas/drawing/frame_load.h"

#include <QPainter>

namespace kriva::ui {
namespace {

// In points, and larger than any mark of a figure.
constexpr double kSelectedSize = 6;
constexpr double kHoveredSize = 8.5;
constexpr double kOutline = 1.2;

constexpr float kBandOpacity = 0.15F;

[[nodiscard]] Color toCore(const QColor& color) {
    return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
            static_cast<std::uint8_t>(color.blue())};
}

} // namespace

std::vector<Stamps> highlights(std::span<const Point> selected, std::optional<Point> hovered,
                               const HighlightColors& colors, StampView view) {
    const Color accent = toCore(colors.accent);
    const RoleStyle disc{toCore(colors.ink), 0, {}, Marker::circle, kSelectedSize, kOutline, accent};
    const RoleStyle ring{accent, 0, {}, Marker::ring, kHoveredSize, kOutline, {}};
    std::vector<Stamps> stamps;
    if (hovered)
        stamps.push_back(stampsAt({&*hovered, 1}, markPicture(ring, view.devicePixelRatio), view));
    view.most = FrameLoad::kMarks;
    Stamps discs = stampsAt(selected, markPicture(disc, view.devicePixelRatio), view);
    for (; static_cast<double>(discs.places.size()) > view.most; view.spacing *= 2)
        discs = stampsAt(selected, discs.picture, view);
    stamps.insert(stamps.begin(), std::move(discs));
    return stamps;
}

void paintRubberBand(QPainter& painter, const QRectF& band, const HighlightColors& colors) {
    QColor fill = colors.accent;
    fill.setAlphaF(kBandOpacity);
    painter.setPen(colors.accent);
    painter.setBrush(fill);
    painter.drawRect(band);
}

} // namespace kriva::ui
