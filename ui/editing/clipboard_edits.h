#pragma once

#include <QString>

namespace kriva::ui {

class SheetEditor;

// The edits of a sheet that go by way of the clipboard. They mean the selected points of the active curve, and where
// none is selected the curve itself.

/// False where there is nothing to copy.
bool copyToClipboard(const SheetEditor& editor);
/// Copies and removes, in one step.
void cutToClipboard(SheetEditor& editor);
/// Points come behind those of the active curve and are selected, a curve comes above the others; one step in any case.
/// Gives one line that says why the clipboard was refused, empty where it was not.
[[nodiscard]] QString pasteFromClipboard(SheetEditor& editor);
/// What copying and pasting would do, past the clipboard.
void duplicateSelected(SheetEditor& editor);

} // namespace kriva::ui
