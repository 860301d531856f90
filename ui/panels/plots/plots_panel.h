#pragma once

#include "ui/controls/kept_choice.h"
#include "ui/editing/results/curve_work.h"
#include "ui/panels/plots/plot_view.h"
#include "ui/panels/watched_panel.h"

#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace kriva::ui {

/// The plots of the active curve, one group at a time, live, with a common crosshair and the values under it.
class PlotsPanel : public QWidget, public WatchedPanel {
    Q_OBJECT
  public:
    explicit PlotsPanel(ShownSheet& sheet, QWidget* parent = nullptr);
    void setWatched(bool isWatched) override;

  Q_SIGNALS:
    /// The plots on view are to be written into a file.
    void exportRequested(const std::vector<kriva::Plot>& plots);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    struct Row {
        QLabel* title;
        PlotView* view;
        QLabel* values;
    };
    void retranslateUi();
    void take(std::vector<PlotGroup> groups);
    void showNames();
    void showGroup();
    void makeRows(std::size_t count);
    void showValues();

    std::vector<PlotGroup> groups_;
    KeptChoice* choice_;
    QToolButton* export_;
    QVBoxLayout* layout_;
    std::vector<Row> rows_;
    CurveWork work_;
};

} // namespace kriva::ui
