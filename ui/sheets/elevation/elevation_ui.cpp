#include "ui/sheets/elevation/elevation_ui.h"

#include "ui/sheets/elevation/elevation_properties.h"

namespace kriva::ui {

SheetUi elevationUi() {
    return {QT_TRANSLATE_NOOP("Sheet", "Elevation"),
            [](SheetEditor& editor, QWidget* parent) { return new ElevationProperties(editor, parent); },
            {}};
}

} // namespace kriva::ui
