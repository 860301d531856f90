#pragma once

#include "ui/canvas/canvas_input.h"

#include <QRectF>

class QMouseEvent;
class QWheelEvent;

namespace kriva::ui {

class CanvasView;

inline constexpr double kZoomStep = 1.25; ///< of Zoom in and of a notch of the wheel

/// What the mouse does on a canvas: where a click becomes a drag, a rubber band or a pan, and how each of them ends.
class Gestures {
  public:
    Gestures(CanvasView& view, CanvasInput& input);

    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void doubleClick(const QMouseEvent& event);
    /// Scrolls, sideways with Shift, or zooms at the pointer with Ctrl.
    void wheel(QWheelEvent& event);
    /// The pointer is elsewhere: nothing is hovered any more.
    void leave();
    /// While it is held before a press, the press pans; what it means in a drag is the input's to say.
    void setSpaceHeld(bool isHeld);
    /// The view or the modifier keys changed under a pointer that stands still.
    void follow(Qt::KeyboardModifiers modifiers);
    /// Curves changed under it; a drag that changes them knows.
    void lookAgain();

    [[nodiscard]] PointerEvent eventAt(QPointF pixel, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) const;
    /// Where a point would be inserted.
    [[nodiscard]] std::optional<CurvePlace> curveUnderPointer() const;

    /// Whether a mouse button that means something is down.
    [[nodiscard]] bool isRunning() const { return state_ != State::idle; }
    /// Takes back what goes on.
    void cancel();
    /// Ends it as if the button had been released.
    void finish();
    void showCursor();

  private:
    enum class State { idle, pressed, dragging, banding, panning };
    void startDrag();
    void finishBand();
    void setState(State state);
    [[nodiscard]] QRectF band() const;

    CanvasView& view_;
    CanvasInput& input_;
    State state_ = State::idle;
    PointerEvent press_;
    QPointF pixel_;                   ///< where the pointer is
    Qt::KeyboardModifiers modifiers_; ///< as last told
    bool isPointerInside_ = false;
    bool isSpaceHeld_ = false;
};

} // namespace kriva::ui
