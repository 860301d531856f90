#pragma once

#include "ui/tabs/sheet_ui.h"

namespace kriva::ui {

[[nodiscard]] SheetUi elevationUi();

} // namespace kriva::ui
