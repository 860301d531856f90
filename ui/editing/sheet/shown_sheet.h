#pragma once

#include "ui/canvas/base/selection.h"
#include "ui/document/open_document.h"

class QThreadPool;

namespace kriva::ui {

/// One sheet of the open document as its tab shows it, with the view state that belongs to it and is neither saved nor
/// undone: the selection, and the stage that a player shows.
class ShownSheet : public QObject {
    Q_OBJECT
  public:
    /// What is worked out from the sheet comes from these threads; they outlive it.
    ShownSheet(OpenDocument& document, QThreadPool& workers, SheetIndex sheet, QObject* parent = nullptr);

    [[nodiscard]] OpenDocument& document() const { return document_; }
    [[nodiscard]] QThreadPool& workers() const { return workers_; }
    [[nodiscard]] const Sheet& sheet() const { return document_.sheet(index_); }
    [[nodiscard]] SheetIndex index() const { return index_; }
    [[nodiscard]] Serial activeSerial() const { return document_.activeCurve(index_); }
    void activate(Serial serial) { document_.setActiveCurve(index_, serial); }
    /// Null in an empty sheet.
    [[nodiscard]] const Curve* activeCurve() const { return document_.find(index_, activeSerial()); }

    /// The curve as it is on view: a player's stage, else the document's value.
    [[nodiscard]] const Curve* shown(Serial serial) const;
    /// A copy of it for other threads, one for all who ask before it changes; null where there is no such curve.
    [[nodiscard]] std::shared_ptr<const Curve> snapshot(Serial serial) const;
    /// Shows another value in place of the active curve's without changing the document; nothing shows the document's.
    void setStage(std::optional<Curve> stage);
    /// Hides the layers of the active curve that its sheet's algorithm brings only after that stage; nothing shows all.
    /// It stays where the curve changes, so that one can pull at a point and watch one stage.
    void setLayerStage(std::optional<int> stage);
    [[nodiscard]] std::optional<int> layerStage() const { return layerStage_; }
    /// The sheet with the stage in place of the active curve.
    [[nodiscard]] Sheet sheetOnView() const;
    /// The whole document with the stage in place of the active curve: what an export draws, hidden layers aside.
    [[nodiscard]] Document documentOnView() const;
    [[nodiscard]] bool hasStage() const { return stage_ != nullptr; }

    /// Places that a panel points out on the canvas, which scrolls to the first of them.
    void pointOut(Points places);
    /// They moved; where there are none, none are pointed out any more.
    void movePointedOut(Points places);
    [[nodiscard]] const Points& pointedOut() const { return pointedOut_; }

    [[nodiscard]] const Selection& selection() const { return selection_; }
    void select(Selection selection);
    void selectAll();
    void selectNone();
    void invertSelection();
    [[nodiscard]] bool hasSelectedPoints() const;
    /// Indices of the selected points of the active curve, ascending.
    [[nodiscard]] std::vector<int> selectedPoints() const;
    [[nodiscard]] std::vector<GripId> selectedGrips(Serial serial) const;

  Q_SIGNALS:
    void selectionChanged();
    void pointedOutChanged(bool areNew);
    /// What is on view for this curve changed: its value, or the stage in its place.
    void shownCurveChanged(kriva::ui::Serial serial);

  protected:
    /// Selects what was `selected` before the points of a curve were renumbered.
    void selectMapped(const Selection& selected, Serial serial, const IndexMap& map);

  private:
    [[nodiscard]] Selection allPoints() const;
    void dropLostSelection();
    void dropStages();

    OpenDocument& document_;
    QThreadPool& workers_;
    SheetIndex index_;
    Selection selection_;
    Points pointedOut_;
    std::shared_ptr<const Curve> stage_; ///< null while the document's value is shown
    std::optional<int> layerStage_;
    Serial stagedSerial_ = 0; ///< in whose place the stage stands, or whose layers it hides
};

} // namespace kriva::ui
