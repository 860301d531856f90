#pragma once

#include "core/geometry/point.h"
#include "ui/canvas/base/selection.h"

#include <QPointF>
#include <Qt>

namespace kriva::ui {

enum class Tool { edit, add };

/// Whether the neighbours of a removed point are refitted so that the shape changes least.
enum class Removal { refitted, plain };

/// A mouse button that went down on a canvas, or the pointer that hovers over it, and what it found there.
struct PointerEvent {
    QPointF pixel;
    Point at; ///< the same place, in document units
    Qt::MouseButton button = Qt::NoButton;
    Qt::KeyboardModifiers modifiers;
    Hit under;

    [[nodiscard]] bool with(Qt::KeyboardModifier modifier) const { return modifiers.testFlag(modifier); }
};

/// What is held while a drag goes on.
struct DragKeys {
    Qt::KeyboardModifiers modifiers;
    bool isSpaceHeld = false;

    [[nodiscard]] bool with(Qt::KeyboardModifier modifier) const { return modifiers.testFlag(modifier); }
};

/// What mouse and keys do on a canvas, told to the owner of the values, who decides what it means for them. The canvas
/// changes nothing by itself: it shows the answer when its scene is given new curves or a new selection.
class CanvasInput {
  public:
    virtual ~CanvasInput() = default;

    /// Nothing is pressed. Also told when a modifier key is pressed or released, and when what is under the pointer
    /// changed.
    virtual void hover(const PointerEvent& now) = 0;
    /// The button came up in the same place. The menu key clicks with the right button on what is selected.
    virtual void click(const PointerEvent& press) = 0;
    /// False where the second press of a double-click is one more press.
    [[nodiscard]] virtual bool doubleClick(const PointerEvent& press) = 0;

    /// The pointer moves on before the left button comes up. False where that is the drag of nothing, and draws a
    /// rubber band; else any number of drag follow, then endDrag or cancelDrag.
    [[nodiscard]] virtual bool beginDrag(const PointerEvent& press) = 0;
    /// `by` is the whole displacement since the press. Told anew when a key is pressed or released.
    virtual void drag(Vector by, const DragKeys& keys) = 0;
    virtual void endDrag() = 0;
    virtual void cancelDrag() = 0;

    virtual void select(Selection selection) = 0;

    // The keys for what is selected, but for the place, where the pointer is on a curve.

    virtual void nudge(Vector by) = 0;
    virtual void removeSelected(Removal removal) = 0;
    virtual void insertPoint(std::optional<CurvePlace> place) = 0;
};

} // namespace kriva::ui
