#pragma once

#include "ui/canvas/canvas_view.h"
#include "ui/editing/sheet_editor.h"

namespace kriva::ui {

/// Where the pointer is, over what, and with which keys and tool.
struct Pointing {
    Hit under;
    Point at;
    Qt::KeyboardModifiers modifiers;
    Tool tool = Tool::edit;
};

/// Where a point would come if it were inserted now; nothing where a click would insert none.
[[nodiscard]] std::optional<Point> ghostFor(const SheetEditor& editor, const Pointing& now);

/// What a person can do next; a click on the mark under the pointer may explain it.
[[nodiscard]] QString hintFor(const SheetEditor& editor, const Pointing& now, bool canExplain);

} // namespace kriva::ui
