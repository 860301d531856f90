#pragma once

#include "ui/canvas/base/selection.h"

namespace kriva::ui {

class CanvasView;

/// Has screen readers see canvases with their curves, and curves with their points: each has a name, a place, and can
/// be selected. To be called once or more, before the first of them looks.
void makeAccessible();

/// Tells screen readers that the selection is this point now.
void announcePoint(CanvasView& canvas, const GripRef& grip);

} // namespace kriva::ui
