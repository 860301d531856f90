#pragma once

#include "ui/tabs/sheet_ui.h"

namespace kriva::ui {

/// Makes two curves of the active one, cut at its t as it is on view.
void splitAtCut(SheetEditor& editor);

[[nodiscard]] std::vector<SheetAction> subdivisionActions();

} // namespace kriva::ui
