#pragma once

#include "ui/canvas/canvas_view.h"

namespace kriva::ui {

/// What a person can do next, given what lies under the pointer and which keys are held.
[[nodiscard]] QString hintText(const Hit& under, Qt::KeyboardModifiers modifiers, Tool tool);

} // namespace kriva::ui
