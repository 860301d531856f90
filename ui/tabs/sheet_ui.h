#pragma once

#include "ui/panels/points_panel.h"
#include "ui/panels/tables/tables_panel.h"

#include <QKeySequence>

#include <functional>
#include <vector>

namespace kriva::ui {

class SheetEditor;

/// An action that only this sheet has: in the Curve menu and in context menus.
struct SheetAction {
    enum class Group { joins, handles, curve };

    Group group = Group::curve;
    const char* name = ""; ///< of the QAction
    const char* text = ""; ///< marked with QT_TRANSLATE_NOOP("SheetActions", ...)
    QKeySequence shortcut; ///< on the canvas only
    std::function<void(SheetEditor&)> run;
    std::function<bool(const SheetEditor&)> isPossible; ///< asked only where there is an active curve
    std::function<bool(const SheetEditor&)> isChecked;  ///< nothing for what is not switched on and off
};

/// The number that Page Up raises and Page Down lowers, one at a time.
struct SheetNumber {
    struct Range {
        int low = 0;
        int high = 0;
    };
    const char* raiseText = ""; ///< marked with QT_TRANSLATE_NOOP("SheetActions", ...)
    const char* lowerText = "";
    StepLabel step;
    std::function<int(const Curve&)> value;
    std::function<Range(const Curve&)> range;
    std::function<Curve(const Curve&, int)> with;
};

/// What a sheet's folder in ui/tabs brings to its tab.
struct SheetUi {
    const char* title = ""; ///< marked with QT_TRANSLATE_NOOP("Sheet", ...)
    std::function<QWidget*(SheetEditor&, QWidget*)> makeProperties;
    std::vector<PointColumn> pointColumns = {}; ///< of the Points table, behind index, x and y
    SheetNumber number;
    std::vector<SheetAction> actions = {}; ///< by groups
    TablesPanel::Tables tables = [](const Curve& curve, WorkBudget& budget) { return tablesOf(curve, budget); };
    std::vector<Role> explained = {}; ///< of marks that stand in the tables
};

} // namespace kriva::ui
