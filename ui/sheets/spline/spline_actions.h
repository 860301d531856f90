#pragma once

#include "ui/sheets/sheet_ui.h"

namespace kriva::ui {

/// Joins and handles of the selected knots, and of the knots whose handles are selected; closing the chain.
[[nodiscard]] std::vector<SheetAction> splineActions();

} // namespace kriva::ui
