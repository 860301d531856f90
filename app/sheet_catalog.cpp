#include "app/sheet_catalog.h"

#include "ui/sheets/combined/combined_ui.h"
#include "ui/sheets/elevation/elevation_ui.h"
#include "ui/sheets/spline/spline_ui.h"
#include "ui/sheets/subdivision/subdivision_ui.h"

namespace kriva {

std::array<ui::SheetUi, kSheetCount> sheetCatalog() {
    return {ui::elevationUi(), ui::subdivisionUi(), ui::splineUi(), ui::combinedUi()};
}

} // namespace kriva
