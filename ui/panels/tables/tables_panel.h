#pragma once

#include "ui/controls/kept_choice.h"
#include "ui/editing/results/curve_work.h"
#include "ui/editing/sheet/pointed_out.h"
#include "ui/panels/tables/table_model.h"
#include "ui/panels/watched_panel.h"

#include <QLabel>
#include <QTableView>
#include <QToolButton>

namespace kriva::ui {

/// The tables of the active curve, one at a time, live; copied as LaTeX or for a spreadsheet. Points that are chosen
/// here are pointed out on the canvas, and how they are worked out stands below where the table says it.
class TablesPanel : public QWidget, public WatchedPanel {
    Q_OBJECT
  public:
    /// What a sheet has to tell of a curve in tables; called on any thread. Nothing where the budget has ended.
    using Tables = std::function<std::optional<std::vector<Table>>(const Curve&, WorkBudget&)>;

    TablesPanel(ShownSheet& sheet, Tables tables, QWidget* parent = nullptr);
    void setWatched(bool isWatched) override;
    /// Chooses the cell where this point of the figure stands, as soon as the tables are those of what is on view;
    /// nothing happens where it stands in none of them.
    void explain(Point point);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void retranslateUi();
    void take(std::vector<Table> tables);
    void showNames();
    void showTable();
    void chooseAsked();
    bool chooseIn(std::size_t table, Point point);
    /// What belongs to the cells that are chosen.
    void widenColumns();
    void followChoice();
    [[nodiscard]] Points chosenPlaces() const;
    void copyLatex() const;
    void copyDelimited() const;

    std::vector<Table> tables_;
    std::optional<Point> asked_; ///< to explain
    TableModel model_;
    KeptChoice* choice_;
    QTableView* view_;
    QLabel* sum_;
    QToolButton* latex_;
    QToolButton* csv_;
    PointedOut pointedOut_;
    CurveWork work_;
};

} // namespace kriva::ui
