#pragma once

#include "core/figure/figure.h"
#include "core/figure/style/page.h"
#include "core/figure/style/theme.h"

class QPainter;

namespace kriva::ui {

/// A stroke of a figure in painter units, `unit` of them a millimetre. On a raster in parts, where one shape would take
/// Qt very long, so that no one sees a difference. Leaves the painter's opacity changed.
void paintStroke(QPainter& painter, const Stroke& stroke, const Page& page, Theme theme, double unit);

} // namespace kriva::ui
