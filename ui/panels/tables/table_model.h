#pragma once

#include "core/curve/table.h"

#include <QAbstractTableModel>

namespace kriva::ui {

/// A table of core in the present language, put into words where it is looked at.
class TableModel : public QAbstractTableModel {
    Q_OBJECT
  public:
    using QAbstractTableModel::QAbstractTableModel;

    void setTable(Table table);
    [[nodiscard]] const Table& table() const { return table_; }
    void retranslate();
    /// Where on the canvas a cell lies; nothing for numbers and words.
    [[nodiscard]] std::optional<Point> place(const QModelIndex& index) const;
    /// How a row's point is worked out, with its numbers: "b₁ = 0.25 · (0; 0) + 0.75 · (4; 8) = (3; 6)"; empty where
    /// the table does not say or has no such row.
    [[nodiscard]] QString sumText(int row) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    /// The best of a column is bold; the tooltip has all digits.
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    Table table_;
};

} // namespace kriva::ui
