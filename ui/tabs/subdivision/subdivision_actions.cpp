#include "ui/tabs/subdivision/subdivision_actions.h"

#include "core/sheets/subdivision/subdivision.h"
#include "ui/editing/sheet_editor.h"

#include <QCoreApplication>

namespace kriva::ui {

void splitAtCut(SheetEditor& editor) {
    const Curve* onView = editor.shown(editor.activeSerial());
    auto parts = onView ? dividedAtCut(std::get<SubdivisionCurve>(*onView)) : std::nullopt;
    if (!parts)
        return;
    editor.setStage({});
    editor.divide(Curve(std::move((*parts)[0])), Curve(std::move((*parts)[1])),
                  {QT_TRANSLATE_NOOP("Step", "Split the curve")});
}

std::vector<SheetAction> subdivisionActions() {
    return {{SheetAction::Group::curve,
             "splitHere",
             QT_TRANSLATE_NOOP("SheetActions", "Split here, at t"),
             {},
             splitAtCut,
             [](const SheetEditor& editor) { return !isIncomplete(*editor.activeCurve()); },
             {}}};
}

} // namespace kriva::ui
