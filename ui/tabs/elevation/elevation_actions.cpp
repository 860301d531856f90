#include "ui/tabs/elevation/elevation_actions.h"

#include "core/sheets/elevation/elevation.h"
#include "ui/editing/sheet_editor.h"

#include <QCoreApplication>

namespace kriva::ui {

void takeElevatedPolygon(SheetEditor& editor) {
    if (!canTakeElevatedPolygon(editor))
        return;
    Curve taken(withElevatedPolygon(std::get<ElevationCurve>(*editor.shown(editor.activeSerial()))));
    editor.setStage({});
    editor.change(std::move(taken), {QT_TRANSLATE_NOOP("Step", "Take the elevated polygon over")});
}

bool canTakeElevatedPolygon(const SheetEditor& editor) {
    const Curve* onView = editor.shown(editor.activeSerial());
    return onView && canTakeElevatedPolygon(std::get<ElevationCurve>(*onView));
}

void reduceDegree(SheetEditor& editor) {
    const Curve* curve = editor.activeCurve();
    std::optional<Refitted<ElevationCurve>> reduced =
        curve ? withDegreeReduced(std::get<ElevationCurve>(*curve)) : std::nullopt;
    if (!reduced)
        return;
    editor.setStage({});
    editor.change(Curve(std::move(reduced->edited.curve)), {QT_TRANSLATE_NOOP("Step", "Reduce the degree")});
}

std::vector<SheetAction> elevationActions() {
    return {{SheetAction::Group::curve,
             "takePolygon",
             QT_TRANSLATE_NOOP("SheetActions", "Make the elevated polygon the control polygon"),
             {},
             takeElevatedPolygon,
             canTakeElevatedPolygon,
             {}}};
}

} // namespace kriva::ui
