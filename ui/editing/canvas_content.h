#pragma once

#include "ui/canvas/canvas_view.h"
#include "ui/editing/figure_worker.h"
#include "ui/editing/results/sheet_relations.h"
#include "ui/editing/sheet/shown_sheet.h"

namespace kriva::ui {

/// Keeps a canvas showing what a sheet has on view: its curves, what they have with each other, and the selection.
/// Curves that a frame has no time to draw are drawn beside the window, and follow.
class CanvasContent : public QObject {
    Q_OBJECT
  public:
    /// All of them outlive this.
    CanvasContent(const ShownSheet& sheet, const SheetRelations& relations, CanvasView& canvas);

    /// Numbers and captions on the canvas follow the language.
    void retranslateUi() { showAll(); }

  private:
    /// All but what drawing gives.
    [[nodiscard]] CanvasCurve undrawn(Serial serial) const;
    [[nodiscard]] FigureContext contextOf(Serial serial) const;
    [[nodiscard]] CanvasCurve drawnNow(Serial serial) const;
    /// The curve with its points alone, until the worker has drawn it.
    [[nodiscard]] CanvasCurve due(Serial serial) const;
    [[nodiscard]] bool isShown(Serial serial) const;
    [[nodiscard]] std::uint64_t stepsToDraw(Serial serial) const;
    /// What the curves have with each other, above them; it is of no curve.
    [[nodiscard]] CanvasCurve relations() const;

    void start();
    void showAll();
    void update(Serial serial);
    /// Hands over as many of the curves that are due as make a batch.
    void drawNext();
    void take(std::vector<CanvasCurve> drawn);
    /// 100 % is the size of the page at 96 dpi. A page grows with its curves, but not under the pointer: only a new
    /// document sets the scale.
    void followPage();

    const ShownSheet& sheet_;
    const SheetRelations& relations_;
    CanvasView& canvas_;
    std::vector<Serial> due_; ///< the first of them next
    bool isNew_ = false;      ///< the document, until all of it is drawn
    FigureWorker worker_;
};

} // namespace kriva::ui
