#include "ui/tabs/elevation/elevation_ui.h"

#include "core/curve/limits.h"
#include "core/sheets/elevation/views/elevation_plots.h"
#include "core/sheets/elevation/views/elevation_tables.h"
#include "ui/tabs/elevation/elevation_actions.h"
#include "ui/tabs/elevation/elevation_properties.h"

namespace kriva::ui {
namespace {

SheetNumber timesNumber() {
    return {
        QT_TRANSLATE_NOOP("SheetActions", "Elevate once more"),
        QT_TRANSLATE_NOOP("SheetActions", "Elevate once less"),
        {QT_TRANSLATE_NOOP("Step", "Raise the degree")},
        [](const Curve& curve) { return std::get<ElevationCurve>(curve).times; },
        [](const Curve& curve) {
            const int times = std::get<ElevationCurve>(curve).times;
            return isIncomplete(curve) ? SheetNumber::Range{times, times} : SheetNumber::Range{0, limits::kElevations};
        },
        [](const Curve& curve, int times) {
            ElevationCurve changed = std::get<ElevationCurve>(curve);
            changed.times = times;
            return Curve(std::move(changed));
        }};
}

} // namespace

SheetUi elevationUi() {
    return {QT_TRANSLATE_NOOP("Sheet", "Elevation"),
            [](SheetEditor& editor, QWidget* parent) { return new ElevationProperties(editor, parent); },
            {},
            timesNumber(),
            elevationActions(),
            [](const Curve& curve, WorkBudget& budget) { return plotsOf(std::get<ElevationCurve>(curve), budget); },
            [](const Curve& curve, WorkBudget& budget) { return tablesOf(std::get<ElevationCurve>(curve), budget); },
            {Role::derivedPolygon}};
}

} // namespace kriva::ui
