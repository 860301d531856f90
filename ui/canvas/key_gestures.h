#pragma once

#include "ui/canvas/canvas_input.h"

class QKeyEvent;

namespace kriva::ui {

class CanvasView;
class Gestures;

/// What the keys do on a canvas.
class KeyGestures {
  public:
    KeyGestures(CanvasView& view, Gestures& mouse, CanvasInput& input);

    /// Whether the key means something here, so that no shortcut of the window takes it.
    [[nodiscard]] bool wants(const QKeyEvent& event) const;
    /// False for a key that means nothing here.
    bool press(const QKeyEvent& event);
    /// Selects the next or previous point; past the last one false, and the focus goes on.
    bool walk(bool isForwards);

  private:
    bool pressSingleKey(const QKeyEvent& event);
    void insert();
    void nudge(Vector direction, Qt::KeyboardModifiers modifiers);
    void escape();
    [[nodiscard]] std::optional<GripRef> neighbourOfSelection(bool isNext) const;

    CanvasView& view_;
    Gestures& mouse_;
    CanvasInput& input_;
    bool hasWalkedOut_ = false; ///< the next walk starts anew
};

/// The letter or digit that the pressed key bears on a US keyboard, so that single-key shortcuts work on Cyrillic
/// layouts; the event's own key where the system does not tell which key it was.
[[nodiscard]] Qt::Key physicalKey(const QKeyEvent& event);

} // namespace kriva::ui
