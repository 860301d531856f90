#pragma once

#include "ui/editing/results/curve_results.h"
#include "ui/editing/sheet/pointed_out.h"
#include "ui/panels/results_model.h"
#include "ui/panels/watched_panel.h"

#include <QTreeView>

namespace kriva::ui {

class SheetRelations;

/// The numbers of the report for the curve on view and for the sheet, live. Places that are chosen here, such as
/// crossings, are pointed out on the canvas.
class ResultsPanel : public QTreeView, public WatchedPanel {
    Q_OBJECT
  public:
    ResultsPanel(ShownSheet& sheet, const SheetRelations& relations, QWidget* parent = nullptr);
    void setWatched(bool isWatched) override;

  protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void selectionChanged(const QItemSelection& selected, const QItemSelection& deselected) override;
    void dataChanged(const QModelIndex& first, const QModelIndex& last, const QList<int>& roles) override;

  private:
    void retranslateUi();
    void showState();
    void showColumns();
    void copy() const;
    [[nodiscard]] Points chosenPlaces() const;

    CurveResults results_;
    const SheetRelations& relations_;
    ResultsModel model_;
    PointedOut pointedOut_;
};

} // namespace kriva::ui
