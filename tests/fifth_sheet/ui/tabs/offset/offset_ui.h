#pragma once

#include "ui/tabs/sheet_ui.h"

namespace kriva::ui {

[[nodiscard]] SheetUi offsetUi();

} // namespace kriva::ui
