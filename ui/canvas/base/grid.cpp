#include "ui/canvas/base/grid.h"

#include "ui/base/language/number_text.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QList>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace kriva::ui {
namespace {

// Stronger lines with numbers are this far apart: room for "-0.0025". With five times the grid's spacing, the steps
// 1, 2, 5 of the grid make 5, 10 and 20 or 50 here: always a multiple.
constexpr double kNumberSpacing = 5 * kGridSpacing;
constexpr double kLineStrength = 0.06;
constexpr double kStrongLineStrength = 0.12;
constexpr double kAxisStrength = 0.45;
constexpr double kNumberStrength = 0.6;
constexpr double kNumberGap = 4; ///< pixels from a number to its axis and to the edge of the view

enum class Axis { x, y };

[[nodiscard]] QColor mixed(const GridLook& look, double strength) {
    const auto part = [strength](int ink, int paper) { return qRound(strength * ink + (1 - strength) * paper); };
    return {part(look.ink.red(), look.paper.red()), part(look.ink.green(), look.paper.green()),
            part(look.ink.blue(), look.paper.blue())};
}

/// Lines sit in the middle of a pixel, so that they are sharp without antialiasing.
[[nodiscard]] double sharp(double pixel) {
    return std::floor(pixel) + 0.5;
}

/// Both families of lines at the multiples of a step, each a pixel wide: filling is ten times faster than stroking.
void paintLines(QPainter& painter, const Viewport& viewport, double step, const QColor& color) {
    const Box seen = visibleBox(viewport);
    for (const double x : multiples(step, seen.xmin, seen.xmax))
        painter.fillRect(QRectF(std::floor(viewport.toPixels({x, 0}).x()), 0, 1, viewport.size.height()), color);
    for (const double y : multiples(step, seen.ymin, seen.ymax))
        painter.fillRect(QRectF(0, std::floor(viewport.toPixels({0, y}).y()), viewport.size.width(), 1), color);
}

/// The axis' place across its direction, or the nearest place where its numbers can be read.
[[nodiscard]] double heldInView(double axis, double numberSize, double viewSize) {
    return std::clamp(axis, 0.0, std::max(0.0, viewSize - numberSize - 2 * kNumberGap));
}

void paintNumbers(QPainter& painter, const Viewport& viewport, Axis axis, const TextSource& texts) {
    const double step = numberStep(viewport);
    const Box seen = visibleBox(viewport);
    const QFontMetricsF letters(painter.font());
    const QPointF origin = viewport.toPixels({0, 0});
    const bool isX = axis == Axis::x;
    double freeFrom = -letters.height();
    for (const double value : multiples(step, isX ? seen.xmin : seen.ymin, isX ? seen.xmax : seen.ymax)) {
        if (value == 0)
            continue;
        const QString text = QString::fromStdString(texts.number(value, decimalsOf(step)));
        const QSizeF size(letters.horizontalAdvance(text), letters.height());
        if (isX) {
            const double left = viewport.toPixels({value, 0}).x() - size.width() / 2;
            if (left < freeFrom)
                continue;
            freeFrom = left + size.width() + 2 * kNumberGap;
            const double top = heldInView(origin.y(), size.height(), viewport.size.height()) + kNumberGap;
            painter.drawText(QPointF(left, top + letters.ascent()), text);
        } else {
            const double left = heldInView(origin.x(), size.width(), viewport.size.width()) + kNumberGap;
            const double middle = viewport.toPixels({0, value}).y();
            painter.drawText(QPointF(left, middle + letters.ascent() / 2), text);
        }
    }
}

void paintAxes(QPainter& painter, const Viewport& viewport, const GridLook& look) {
    const QPointF origin = viewport.toPixels({0, 0});
    painter.setPen(mixed(look, kAxisStrength));
    if (origin.x() >= 0 && origin.x() <= viewport.size.width())
        painter.drawLine(QLineF(sharp(origin.x()), 0, sharp(origin.x()), viewport.size.height()));
    if (origin.y() >= 0 && origin.y() <= viewport.size.height())
        painter.drawLine(QLineF(0, sharp(origin.y()), viewport.size.width(), sharp(origin.y())));
}

} // namespace

double gridStep(const Viewport& viewport) {
    return roundStep(kGridSpacing / viewport.scale);
}

double numberStep(const Viewport& viewport) {
    return roundStep(kNumberSpacing / viewport.scale);
}

double nearestMultiple(double step, double number) {
    return 0.0 + stepped(step * std::round(number / step), 0); // never -0
}

void paintGrid(QPainter& painter, const Viewport& viewport, const GridLook& look, const TextSource& texts) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    if (look.hasGrid) {
        paintLines(painter, viewport, gridStep(viewport), mixed(look, kLineStrength));
        paintLines(painter, viewport, numberStep(viewport), mixed(look, kStrongLineStrength));
    }
    if (look.hasAxes) {
        paintAxes(painter, viewport, look);
        painter.setFont(look.font);
        painter.setPen(mixed(look, kNumberStrength));
        paintNumbers(painter, viewport, Axis::x, texts);
        paintNumbers(painter, viewport, Axis::y, texts);
    }
    painter.restore();
}

} // namespace kriva::ui
