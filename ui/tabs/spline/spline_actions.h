#pragma once

#include "ui/tabs/sheet_ui.h"

namespace kriva::ui {

/// Joins and handles of the selected knots, and of the knots whose handles are selected; closing the chain.
[[nodiscard]] std::vector<SheetAction> splineActions();

/// The knots that are selected by themselves or by a handle, ascending.
[[nodiscard]] std::vector<int> chosenKnots(const SheetEditor& editor);

} // namespace kriva::ui
