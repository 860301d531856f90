#include "ui/sheets/combined/combined_ui.h"

#include "ui/sheets/combined/combined_properties.h"

namespace kriva::ui {

SheetUi combinedUi() {
    return {QT_TRANSLATE_NOOP("Sheet", "Combined"),
            [](SheetEditor& editor, QWidget* parent) { return new CombinedProperties(editor, parent); },
            {}};
}

} // namespace kriva::ui
