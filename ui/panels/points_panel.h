#pragma once

#include "ui/canvas/base/selection.h"
#include "ui/panels/point_delegate.h"
#include "ui/panels/points_model.h"

#include <QTableView>

namespace kriva::ui {

/// The points of the active curve as a table: the twin of the canvas for the keyboard and for screen readers. Its
/// selection and that of the canvas are the same. Who types edits the current cell of a selected row; where no row is
/// both, a new point in the last row.
class PointsPanel : public QTableView {
    Q_OBJECT
  public:
    PointsPanel(SheetEditor& editor, const std::vector<PointColumn>& columns, QWidget* parent = nullptr);

    /// Letters are typed into cells: they do not search.
    void keyboardSearch(const QString&) override {}

  protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void inputMethodEvent(QInputMethodEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

  protected Q_SLOTS:
    void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;

  private:
    void connectModel();
    void retranslateUi();
    void showSelection();
    void takeSelection();
    [[nodiscard]] Selection markedPoints() const;
    void makeCurrent(int row, int column);
    void makeNewRowCurrent() { makeCurrent(model_.newRow(), model_.neededColumn()); }
    void removeRows(Qt::KeyboardModifiers modifiers);
    /// To the cell in which a person types.
    void aim();

    SheetEditor& editor_;
    PointsModel model_;
    PointDelegate* delegate_;
    bool isShowingSelection_ = false;
    bool isTakingSelection_ = false;
    bool hasAddedPoint_ = false; ///< by the cell that is about to be closed
};

} // namespace kriva::ui
