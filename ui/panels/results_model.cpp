#include "ui/panels/results_model.h"

#include "ui/panels/result_text.h"

#include <utility>

namespace kriva::ui {
namespace {

enum Column { nameColumn, valueColumn, columns };

constexpr int kShownDigits = 10;
constexpr int kFullDigits = 17;

} // namespace

void ResultsModel::setResults(std::vector<Result> results) {
    const int before = rowCount();
    const int now = static_cast<int>(results.size());
    if (now > before) {
        beginInsertRows({}, before, now - 1);
        results_ = std::move(results);
        endInsertRows();
    } else if (now < before) {
        beginRemoveRows({}, now, before - 1);
        results_ = std::move(results);
        endRemoveRows();
    } else {
        results_ = std::move(results);
    }
    retranslate();
}

void ResultsModel::retranslate() {
    if (!results_.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columns - 1));
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columns - 1);
}

int ResultsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(results_.size());
}

int ResultsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : columns;
}

QVariant ResultsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || (role != Qt::DisplayRole && role != Qt::ToolTipRole))
        return {};
    const Result& result = results_[static_cast<std::size_t>(index.row())];
    if (index.column() == nameColumn)
        return resultName(result);
    return resultValue(result, role == Qt::ToolTipRole ? kFullDigits : kShownDigits);
}

QVariant ResultsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    return section == nameColumn ? tr("Name") : tr("Value");
}

} // namespace kriva::ui
