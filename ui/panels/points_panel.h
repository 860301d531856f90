#pragma once

#include "ui/panels/points_model.h"

#include <QTableView>

namespace kriva::ui {

/// The points of the active curve as a table: the twin of the canvas for the keyboard and for screen readers. Its
/// selection and that of the canvas are the same.
class PointsPanel : public QTableView {
    Q_OBJECT
  public:
    PointsPanel(SheetEditor& editor, const std::vector<PointColumn>& columns, QWidget* parent = nullptr);

  protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void retranslateUi();
    void showSelection();
    void takeSelection();

    SheetEditor& editor_;
    PointsModel model_;
    bool isShowingSelection_ = false;
};

} // namespace kriva::ui
