#pragma once

#include "core/figure/figure.h"
#include "ui/canvas/base/viewport.h"
#include "ui/canvas/drawing/frame_load.h"

#include <QPolygonF>

#include <vector>

namespace kriva::ui {

/// The polylines that show a path: its pieces clipped to what is seen and flattened in double. QPainter's own drawing
/// of cubics goes astray at high zoom. All points are finite and within `penWidth` + 2 pixels of the view; a path that
/// is nowhere near it has none. A piece of one point is a polyline of two equal ones. What there is to paint is added
/// to the load; once that is too much the rest of the path is not looked at.
[[nodiscard]] std::vector<QPolygonF> visiblePolylines(const Path& path, const Viewport& viewport, double penWidth,
                                                      const Fineness& fineness, FrameLoad& load);

} // namespace kriva::ui
