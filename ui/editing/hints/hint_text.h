#pragma once

#include "ui/canvas/canvas_input.h"

namespace kriva::ui {

/// What lies under the pointer, which keys are held, and what a click would do.
struct HintSituation {
    Hit under;
    Qt::KeyboardModifiers modifiers;
    Tool tool = Tool::edit;
    bool pullsHandles = false; ///< a new point has handles
    bool closes = false;       ///< the point under the pointer closes the curve
    bool explains = false;     ///< the tables tell how the mark under the pointer is worked out
};

/// What a person can do next.
[[nodiscard]] QString hintText(const HintSituation& situation);

/// What the keys held mean for the handle that is being dragged.
[[nodiscard]] QString dragHintText(const DragKeys& keys);

} // namespace kriva::ui
