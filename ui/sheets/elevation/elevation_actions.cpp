#include "ui/sheets/elevation/elevation_actions.h"

#include "core/elevation/elevation_edits.h"
#include "ui/sheets/sheet_editor.h"

#include <QCoreApplication>

namespace kriva::ui {
namespace {

std::optional<ElevationCurve> takenPolygon(const SheetEditor& editor) {
    const Curve* onView = editor.shown(editor.activeSerial());
    return onView ? withElevatedPolygon(std::get<ElevationCurve>(*onView)) : std::nullopt;
}

} // namespace

void takeElevatedPolygon(SheetEditor& editor) {
    std::optional<ElevationCurve> taken = takenPolygon(editor);
    if (!taken)
        return;
    editor.setStage({});
    editor.change(std::move(*taken), {QT_TRANSLATE_NOOP("Step", "Take the elevated polygon over")});
}

bool canTakeElevatedPolygon(const SheetEditor& editor) {
    return takenPolygon(editor).has_value();
}

void reduceDegree(SheetEditor& editor) {
    const Curve* curve = editor.activeCurve();
    std::optional<Refitted<ElevationCurve>> reduced =
        curve ? withDegreeReduced(std::get<ElevationCurve>(*curve)) : std::nullopt;
    if (!reduced)
        return;
    editor.setStage({});
    editor.change(std::move(reduced->edited.curve), {QT_TRANSLATE_NOOP("Step", "Reduce the degree")});
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
