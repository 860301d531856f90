#pragma once

#include "ui/sheets/sheet_ui.h"

namespace kriva::ui {

[[nodiscard]] SheetUi splineUi();

} // namespace kriva::ui
