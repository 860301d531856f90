#pragma once

#include "core/document/results.h"

#include <QAbstractTableModel>

#include <vector>

namespace kriva::ui {

/// Rows of a name and a value, put into words only where they are looked at: a long spline has tens of thousands.
class ResultsModel : public QAbstractTableModel {
    Q_OBJECT
  public:
    using QAbstractTableModel::QAbstractTableModel;

    /// Whether any row has another name than before.
    bool setResults(std::vector<Result> results);
    void retranslate();
    /// Where on the canvas the value of a row lies; nothing for numbers.
    [[nodiscard]] Points places(int row) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    /// The tooltip of a value has all its digits.
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    /// As many as before.
    bool exchange(std::vector<Result> results);
    void tellChanged(int first, int last);

    std::vector<Result> results_;
};

} // namespace kriva::ui
