#include "ui/panels/results_model.h"

#include "ui/panels/result_text.h"

#include <algorithm>
#include <utility>

namespace kriva::ui {
namespace {

enum Column { nameColumn, valueColumn, columns };

/// Of so many rows it takes longer to find which have changed than to show all anew.
constexpr int kManyRows = 10'000;
constexpr int kShownDigits = 10;
constexpr int kFullDigits = 17;

} // namespace

bool ResultsModel::setResults(const Rows& ofCurve, std::vector<Result> ofSheet) {
    Lists results{ofCurve, std::move(ofSheet)};
    const int before = rowCount();
    const int now = static_cast<int>(results.size());
    if (now == before)
        return exchange(std::move(results));
    if (now > before) {
        beginInsertRows({}, before, now - 1);
        results_ = std::move(results);
        endInsertRows();
    } else {
        beginRemoveRows({}, now, before - 1);
        results_ = std::move(results);
        endRemoveRows();
    }
    tellChanged(0, now - 1);
    return true;
}

bool ResultsModel::exchange(Lists lists) {
    const Lists before = std::exchange(results_, std::move(lists));
    if (rowCount() > kManyRows) {
        tellChanged(0, rowCount() - 1);
        return true;
    }
    bool areNamesNew = false;
    int first = rowCount();
    int last = -1;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] == results_[i])
            continue;
        first = std::min(first, static_cast<int>(i));
        last = static_cast<int>(i);
        areNamesNew |= before[i].caption != results_[i].caption || before[i].index != results_[i].index;
    }
    tellChanged(first, last);
    return areNamesNew;
}

void ResultsModel::tellChanged(int first, int last) {
    if (first <= last)
        Q_EMIT dataChanged(index(first, 0), index(last, columns - 1));
}

void ResultsModel::retranslate() {
    tellChanged(0, rowCount() - 1);
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columns - 1);
}

Points ResultsModel::places(int row) const {
    const Result& result = results_[static_cast<std::size_t>(row)];
    if (!result.value)
        return {};
    if (const Point* place = std::get_if<Point>(&*result.value))
        return {*place};
    if (const PassedPlace* place = std::get_if<PassedPlace>(&*result.value))
        return {place->at};
    const Points* places = std::get_if<Points>(&*result.value);
    return places ? *places : Points();
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
