#pragma once

class QWidget;

namespace kriva::ui {

class SheetEditor;

/// Asks for a file with paths or points, shows what would become of it, and adds the curves chosen to the sheet in one
/// step. What is wrong with the file is told. False where nothing was added.
bool importPoints(SheetEditor& editor, QWidget* window);

} // namespace kriva::ui
