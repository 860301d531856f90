#include "ui/tabs/elevation/elevation_ui.h"

#include "core/sheets/elevation/elevation.h"
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
    return {
        .title = QT_TRANSLATE_NOOP("Sheet", "Elevation"),
        .makeProperties = [](SheetEditor& editor, QWidget* parent) { return new ElevationProperties(editor, parent); },
        .number = timesNumber(),
        .actions = elevationActions(),
        .explained = {Role::derivedPolygon}};
}

} // namespace kriva::ui
