#pragma once

#include "ui/canvas/canvas_view.h"
#include "ui/sheets/results/sheet_relations.h"
#include "ui/sheets/shown_sheet.h"

namespace kriva::ui {

/// Keeps a canvas showing what a sheet has on view: its curves, what they have with each other, and the selection.
class CanvasContent : public QObject {
    Q_OBJECT
  public:
    /// All of them outlive this.
    CanvasContent(const ShownSheet& sheet, const SheetRelations& relations, CanvasView& canvas);

    /// Numbers and captions on the canvas follow the language.
    void retranslateUi() { showAll(); }

  private:
    [[nodiscard]] CanvasCurve curve(Serial serial) const;
    /// What the curves have with each other, above them; it is of no curve.
    [[nodiscard]] CanvasCurve relations() const;
    void start();
    void showAll();
    void update(Serial serial);
    /// 100 % is the size of the page at 96 dpi. A page grows with its curves, but not under the pointer: only a new
    /// document sets the scale.
    void followPage();

    const ShownSheet& sheet_;
    const SheetRelations& relations_;
    CanvasView& canvas_;
};

} // namespace kriva::ui
