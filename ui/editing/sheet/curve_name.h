#pragma once

#include "core/document/document.h"

#include <QString>

namespace kriva::ui {

/// What a person calls a curve: its name, else its place in the sheet ("Curve 2"). `index` counts from 0.
[[nodiscard]] QString curveName(const Curve& curve, int index);

} // namespace kriva::ui
