#pragma once

#include <QPointer>
#include <QStyledItemDelegate>

namespace kriva::ui {

class PointsModel;

/// Edits the cells of the Points table: coordinates in the one number field, so that 0.5 and 0,5 mean the same here
/// too, the sheet's own columns as text. A cell that refuses what was typed stays open and says why.
class PointDelegate : public QStyledItemDelegate {
    Q_OBJECT
  public:
    explicit PointDelegate(PointsModel& model, QObject* parent = nullptr);

    /// Closes the field that is open, without applying its text.
    void dropEditor();

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

  protected:
    bool eventFilter(QObject* editor, QEvent* event) override;

  private:
    PointsModel& model_;
    mutable QPointer<QWidget> editor_;
};

} // namespace kriva::ui
