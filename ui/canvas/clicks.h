#pragma once

#include "ui/canvas/canvas_client.h"

#include <QPointF>

namespace kriva::ui {

class CanvasView;

/// A mouse button that went down on a canvas, and what it found there.
struct Press {
    QPointF pixel;
    Point at;
    Qt::MouseButton button = Qt::NoButton;
    Qt::KeyboardModifiers modifiers;
    Hit under;

    [[nodiscard]] bool with(Qt::KeyboardModifier modifier) const { return modifiers.testFlag(modifier); }
};

/// What a press means when the button comes up in the same place.
void click(const Press& press, CanvasView& view, CanvasClient& client);

/// What the second press of a double-click means off any point, with the edit tool and without modifier keys.
void doubleClick(const Press& press, CanvasClient& client);

} // namespace kriva::ui
