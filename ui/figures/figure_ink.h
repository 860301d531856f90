#pragma once

#include "core/figure/label_placement.h"
#include "core/figure/role_style.h"

#include <QColor>
#include <QFont>
#include <QPainterPath>
#include <QPen>
#include <QPointF>

class QPainter;

/// How the parts of a figure are painted with a QPainter, the same on the canvas, in pictures and in print. `pointSize`
/// is the length of a point (1/72 inch) in the painter's units.
namespace kriva::ui {

[[nodiscard]] inline QColor toQt(Color color) {
    return {color.red, color.green, color.blue};
}

/// The pen of a role's lines.
[[nodiscard]] QPen penOf(const RoleStyle& style, double pointSize);

void paintMark(QPainter& painter, const RoleStyle& style, QPointF at, double pointSize);

struct LabelFonts {
    QFont text;
    QFont variable; ///< letters of formulas
    QFont subscript;
};
[[nodiscard]] LabelFonts labelFonts(double pointSize);

/// `baseline` is the label's own in the painter's units, like the result: the outlines of its letters.
[[nodiscard]] QPainterPath labelOutlines(const PlacedLabel& label, QPointF baseline, const LabelFonts& fonts);

/// `baseline` is the label's own in the painter's units.
void paintLabel(QPainter& painter, const PlacedLabel& label, QPointF baseline, const LabelFonts& fonts);

} // namespace kriva::ui
