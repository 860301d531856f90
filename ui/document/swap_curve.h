#pragma once

#include "ui/document/serial_document.h"

#include <QUndoCommand>

namespace kriva::ui {

class OpenDocument;

/// The one command of all histories: it holds what the curve is not at present (nothing where the curve is not there)
/// and exchanges the two. Adding, deleting, changing and reordering are all this.
class SwapCurve : public QUndoCommand {
  public:
    /// `other` is what undo will restore; the change itself has been made already.
    SwapCurve(OpenDocument& document, SheetIndex sheet, Serial serial, std::optional<PlacedCurve> other,
              const QString& label);
    void undo() override;
    void redo() override;

  private:
    OpenDocument& document_;
    SheetIndex sheet_;
    Serial serial_;
    std::optional<PlacedCurve> other_;
    bool isFirstRedo_ = true; ///< QUndoStack::push calls redo, but the change is made already
};

} // namespace kriva::ui
