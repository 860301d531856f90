#pragma once

#include "core/document/document.h"
#include "ui/tabs/sheet_ui.h"

namespace kriva {

/// What each sheet brings to the window, in the order of the document's kinds of curves.
[[nodiscard]] std::array<ui::SheetUi, kSheetCount> sheetCatalog();

} // namespace kriva
