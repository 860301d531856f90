#pragma once

#include "ui/panels/points_panel.h"

#include <functional>
#include <vector>

namespace kriva::ui {

class SheetEditor;

/// What a sheet's folder in ui/sheets brings to its tab.
struct SheetUi {
    const char* title = ""; ///< marked with QT_TRANSLATE_NOOP("Sheet", ...)
    std::function<QWidget*(SheetEditor&, QWidget*)> makeProperties;
    std::vector<PointColumn> pointColumns; ///< of the Points table, behind index, x and y
};

} // namespace kriva::ui
