#pragma once

#include "core/document/grip.h"
#include "ui/document/step_label.h"

namespace kriva::ui {

/// What moving a grip is called in the history.
[[nodiscard]] StepLabel moveLabel(const GripId& grip);

} // namespace kriva::ui
