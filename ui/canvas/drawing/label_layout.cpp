#include "ui/canvas/drawing/label_layout.h"

#include "ui/canvas/qt_geometry.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <array>

namespace kriva::ui {
namespace {

// From a point to the nearest edge of its label: clear of the largest mark.
constexpr double kGap = 6;
// How far a subscript stands below the line, as a part of the letters' height.
constexpr double kSubscriptDrop = 0.25;

[[nodiscard]] QString textOf(const Label& label, const TextSource& texts) {
    if (label.caption != Caption::none && texts.translate)
        return QString::fromStdString(texts.translate(label.caption));
    return QString::fromStdString(label.text);
}

[[nodiscard]] QSizeF sizeOf(const PlacedLabel& label, const LabelLook& look) {
    const QFontMetricsF letters(look.font);
    const double subscript = QFontMetricsF(look.subscriptFont).horizontalAdvance(label.subscript);
    return {letters.horizontalAdvance(label.text) + subscript, letters.height()};
}

/// The places around a point, the best one first.
[[nodiscard]] std::array<QRectF, 8> placesAround(QPointF point, QSizeF size) {
    const double left = point.x() - kGap / 2 - size.width();
    const double right = point.x() + kGap / 2;
    const double above = point.y() - kGap / 2 - size.height();
    const double below = point.y() + kGap / 2;
    const QPointF middle = point - QPointF(size.width(), size.height()) / 2;
    return {{{{right, above}, size},
             {{left, above}, size},
             {{right, below}, size},
             {{left, below}, size},
             {{middle.x(), above - kGap / 2}, size},
             {{middle.x(), below + kGap / 2}, size},
             {{right + kGap / 2, middle.y()}, size},
             {{left - kGap / 2, middle.y()}, size}}};
}

[[nodiscard]] QRectF freePlace(QPointF point, QSizeF size, const std::vector<QRectF>& obstacles) {
    const auto places = placesAround(point, size);
    const auto isFree = [&](const QRectF& place) {
        return std::ranges::none_of(obstacles, [&](const QRectF& obstacle) { return obstacle.intersects(place); });
    };
    const auto free = std::ranges::find_if(places, isFree);
    return free == places.end() ? places.front() : *free;
}

} // namespace

LabelLook labelLook(QFont family, Theme theme, TextSource texts) {
    LabelLook look{family, family, theme, std::move(texts)};
    look.font.setPixelSize(qRound(kTextSize * kPixelsPerPoint));
    look.subscriptFont.setPixelSize(qRound(kSubscriptSize * kPixelsPerPoint));
    return look;
}

std::vector<PlacedLabel> placedLabels(std::span<const Label> labels, std::vector<QRectF> obstacles,
                                      const Viewport& viewport, const LabelLook& look) {
    const QRectF seen(QPointF(), viewport.size);
    const auto isSeen = [&](const Label& label) { return seen.contains(viewport.toPixels(label.at)); };
    if (static_cast<std::size_t>(std::ranges::count_if(labels, isSeen)) > kMostLabels)
        return {};
    std::vector<PlacedLabel> placed;
    for (const Label& label : labels) {
        if (!isSeen(label))
            continue;
        PlacedLabel next{{},
                         textOf(label, look.texts),
                         QString::fromStdString(label.subscript),
                         toQt(styleOf(label.role, 0, look.theme).color)};
        next.box = freePlace(viewport.toPixels(label.at), sizeOf(next, look), obstacles);
        obstacles.push_back(next.box);
        placed.push_back(std::move(next));
    }
    return placed;
}

void paint(QPainter& painter, std::span<const PlacedLabel> labels, const LabelLook& look) {
    const QFontMetricsF letters(look.font);
    for (const PlacedLabel& label : labels) {
        const QPointF baseline = label.box.topLeft() + QPointF(0, letters.ascent());
        painter.setPen(label.color);
        painter.setFont(look.font);
        painter.drawText(baseline, label.text);
        painter.setFont(look.subscriptFont);
        painter.drawText(baseline + QPointF(letters.horizontalAdvance(label.text), kSubscriptDrop * letters.ascent()),
                         label.subscript);
    }
}

} // namespace kriva::ui
