#pragma once

#include "ui/tabs/sheet_ui.h"

namespace kriva::ui {

[[nodiscard]] SheetUi subdivisionUi();

} // namespace kriva::ui
