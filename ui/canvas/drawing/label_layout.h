#pragma once

#include "core/figure/figure.h"
#include "core/figure/role_style.h"
#include "core/figure/text_source.h"
#include "ui/canvas/viewport.h"

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QString>

#include <span>
#include <vector>

class QPainter;

namespace kriva::ui {

/// How labels look, of a constant size on the screen, and in which language they speak.
struct LabelLook {
    QFont font;
    QFont subscriptFont;
    Theme theme = Theme::light;
    TextSource texts;
};
[[nodiscard]] LabelLook labelLook(QFont family, Theme theme, TextSource texts);

/// A label beside its point, in pixels.
struct PlacedLabel {
    QRectF box;
    QString text;
    QString subscript;
    QColor color;
};

/// Nobody reads more labels than this at once: beyond it none is drawn.
inline constexpr std::size_t kMostLabels = 200;

/// The labels whose points are seen, each close to its point and, where there is such a place, covering no other label
/// and none of the obstacles.
[[nodiscard]] std::vector<PlacedLabel> placedLabels(std::span<const Label> labels, std::vector<QRectF> obstacles,
                                                    const Viewport& viewport, const LabelLook& look);

void paint(QPainter& painter, std::span<const PlacedLabel> labels, const LabelLook& look);

} // namespace kriva::ui
