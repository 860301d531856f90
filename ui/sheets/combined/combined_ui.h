#pragma once

#include "ui/sheets/sheet_ui.h"

namespace kriva::ui {

[[nodiscard]] SheetUi combinedUi();

} // namespace kriva::ui
