#include "app/sheet_catalog.h"

#include "ui/tabs/combined/combined_ui.h"
#include "ui/tabs/elevation/elevation_ui.h"
#include "ui/tabs/offset/offset_ui.h"
#include "ui/tabs/spline/spline_ui.h"
#include "ui/tabs/subdivision/subdivision_ui.h"

namespace kriva {

/// The catalogue of the program with one more row at its end.
std::array<ui::SheetUi, kSheetCount> sheetCatalog() {
    return {ui::elevationUi(), ui::subdivisionUi(), ui::splineUi(), ui::combinedUi(), ui::offsetUi()};
}

} // namespace kriva
