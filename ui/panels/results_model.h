#pragma once

#include "core/curve/results.h"

#include <QAbstractTableModel>

#include <memory>
#include <vector>

namespace kriva::ui {

/// Rows of a name and a value, put into words only where they are looked at: a long spline has tens of thousands.
class ResultsModel : public QAbstractTableModel {
    Q_OBJECT
  public:
    using QAbstractTableModel::QAbstractTableModel;

    using Rows = std::shared_ptr<const std::vector<Result>>;

    /// Those of the curve, then those of the sheet. Whether any row has another name than before.
    bool setResults(const Rows& ofCurve, std::vector<Result> ofSheet);
    void retranslate();
    /// Where on the canvas the value of a row lies; nothing for numbers.
    [[nodiscard]] Points places(int row) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    /// The tooltip of a value has all its digits.
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    struct Lists {
        Rows ofCurve = std::make_shared<const std::vector<Result>>();
        std::vector<Result> ofSheet;

        [[nodiscard]] std::size_t size() const { return ofCurve->size() + ofSheet.size(); }
        [[nodiscard]] const Result& operator[](std::size_t row) const {
            return row < ofCurve->size() ? (*ofCurve)[row] : ofSheet[row - ofCurve->size()];
        }
    };
    /// As many as before.
    bool exchange(Lists lists);
    void tellChanged(int first, int last);

    Lists results_;
};

} // namespace kriva::ui
