#include "ui/document/swap_curve.h"

#include "ui/document/open_document.h"

namespace kriva::ui {

SwapCurve::SwapCurve(OpenDocument& document, SheetIndex sheet, Serial serial, std::optional<PlacedCurve> other,
                     const QString& label)
    : QUndoCommand(label)
    , document_(document)
    , sheet_(sheet)
    , serial_(serial)
    , other_(std::move(other)) {}

void SwapCurve::undo() {
    other_ = document_.exchange(sheet_, serial_, std::move(other_));
}

void SwapCurve::redo() {
    if (isFirstRedo_)
        isFirstRedo_ = false;
    else
        undo();
}

} // namespace kriva::ui
