#pragma once

#include "core/io/drawing/drawing.h"

class QPainter;

namespace kriva::ui {

/// Paints a drawing as the file formats of Qt have it: exact curves up to cubics, higher ones within kCubicTolerance.
/// `unit` is a millimetre in the painter's units, whose origin is the page's top left corner.
void paintDrawing(QPainter& painter, const Drawing& drawing, const TextSource& texts, double unit);

} // namespace kriva::ui
