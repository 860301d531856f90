#pragma once

#include "core/curve/editing/grip.h"
#include "ui/document/step_label.h"

namespace kriva::ui {

/// What moving a grip is called in the history.
[[nodiscard]] StepLabel moveLabel(const GripId& grip);

/// What retracting a handle is called, or giving up an end derivative.
[[nodiscard]] StepLabel retractLabel(const GripId& grip);

} // namespace kriva::ui
