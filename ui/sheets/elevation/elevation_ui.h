#pragma once

#include "ui/sheets/sheet_ui.h"

namespace kriva::ui {

[[nodiscard]] SheetUi elevationUi();

} // namespace kriva::ui
