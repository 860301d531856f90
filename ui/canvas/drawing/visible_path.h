#pragma once

#include "core/figure/figure.h"
#include "ui/canvas/viewport.h"

#include <QPolygonF>

#include <vector>

namespace kriva::ui {

/// How finely a path is drawn, in pixels.
struct Fineness {
    double tolerance = 0.1; ///< between the path and its chords
    double spacing = 0.25;  ///< points closer than this to the one before are left out
};

/// The polylines that show a path: its pieces clipped to what is seen and flattened in double. QPainter's own drawing
/// of cubics goes astray at high zoom. All points are finite and within `margin` pixels of the view; a path that is
/// nowhere near it has none. A piece of one point is a polyline of two equal ones.
[[nodiscard]] std::vector<QPolygonF> visiblePolylines(const Path& path, const Viewport& viewport, double margin,
                                                      Fineness fineness = {});

} // namespace kriva::ui
