#pragma once

#include "ui/document/serial_document.h"

#include <QUndoCommand>

namespace kriva::ui {

class OpenDocument;

/// The one command of all histories: it holds what curves are not at present (nothing where a curve is not there) and
/// exchanges the two. Adding, deleting, changing, dividing and reordering are all this.
class SwapCurves : public QUndoCommand {
  public:
    /// `others` are what undo will restore, in this order; the change itself has been made already.
    SwapCurves(OpenDocument& document, SheetIndex sheet, std::vector<CurveExchange> others, const QString& label);
    void undo() override;
    void redo() override;

  private:
    OpenDocument& document_;
    SheetIndex sheet_;
    std::vector<CurveExchange> others_;
    bool isFirstRedo_ = true; ///< QUndoStack::push calls redo, but the change is made already
};

} // namespace kriva::ui
