#pragma once

#include "ui/tabs/sheet_ui.h"

namespace kriva::ui {

/// The elevated polygon as it is on view becomes the control polygon; nothing happens where it cannot.
void takeElevatedPolygon(SheetEditor& editor);
[[nodiscard]] bool canTakeElevatedPolygon(const SheetEditor& editor);

/// The best curve of one degree less; nothing happens for lines.
void reduceDegree(SheetEditor& editor);

[[nodiscard]] std::vector<SheetAction> elevationActions();

} // namespace kriva::ui
