#include "ui/document/swap_curves.h"

#include "ui/document/open_document.h"

namespace kriva::ui {

SwapCurves::SwapCurves(OpenDocument& document, SheetIndex sheet, std::vector<CurveExchange> others,
                       const QString& label)
    : QUndoCommand(label)
    , document_(document)
    , sheet_(sheet)
    , others_(std::move(others)) {}

void SwapCurves::undo() {
    others_ = document_.exchange(sheet_, std::move(others_));
}

void SwapCurves::redo() {
    if (isFirstRedo_)
        isFirstRedo_ = false;
    else
        undo();
}

} // namespace kriva::ui
