#pragma once

#include "ui/canvas/clicks.h"

namespace kriva::ui {

enum class DragKind {
    none,
    drag, ///< of what the client was told
    band, ///< a rubber band
};

/// What a press means when the pointer moves on before the button comes up; the client is told where a drag begins.
DragKind beginDrag(const Press& press, CanvasView& view, CanvasClient& client);

/// How far a drag has come. Ctrl locks the way of a point to an axis.
[[nodiscard]] Vector wayOf(const Press& press, Point now, Qt::KeyboardModifiers modifiers);

} // namespace kriva::ui
