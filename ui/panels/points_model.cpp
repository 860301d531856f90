#include "ui/panels/points_model.h"

#include "core/exchange/conversion.h"
#include "ui/sheets/sheet_editor.h"
#include "ui/shell/language/number_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace kriva::ui {
namespace {

constexpr int kOwnColumns = 2; // x and y

// As much as a narrow column shows; the editor and the tooltip give every digit.
constexpr int kDigits = 6;

std::size_t ownColumn(int column) {
    return static_cast<std::size_t>(column - kOwnColumns);
}

/// The first and the last row with another point; all, where no point differs: then something else does.
std::pair<int, int> differingRows(const Points& before, const Points& now) {
    const auto first = std::ranges::mismatch(before, now).in1 - before.begin();
    if (first == std::ssize(before))
        return {0, static_cast<int>(first) - 1};
    const auto isSame = [&](std::ptrdiff_t i) {
        return before[static_cast<std::size_t>(i)] == now[static_cast<std::size_t>(i)];
    };
    std::ptrdiff_t last = std::ssize(before) - 1;
    while (isSame(last))
        --last;
    return {static_cast<int>(first), static_cast<int>(last)};
}

} // namespace

PointsModel::PointsModel(SheetEditor& editor, std::vector<PointColumn> columns, QObject* parent)
    : QAbstractTableModel(parent)
    , editor_(editor)
    , columns_(std::move(columns)) {
    // Another curve may have the same points with other joins.
    const auto followAll = [this] {
        follow();
        tellChanged(0, rowCount() - 1);
    };
    const auto followAllOfMine = [this, followAll](SheetIndex sheet) {
        if (sheet == editor_.index())
            followAll();
    };
    connect(&editor.document(), &OpenDocument::replaced, this, followAll);
    connect(&editor.document(), &OpenDocument::curvesChanged, this, followAllOfMine);
    connect(&editor.document(), &OpenDocument::viewChanged, this, followAllOfMine);
    connect(&editor.document(), &OpenDocument::curveChanged, this, [this](SheetIndex sheet) {
        if (sheet == editor_.index())
            follow();
    });
    follow();
}

void PointsModel::follow() {
    const Curve* curve = editor_.activeCurve();
    Points now = curve ? pointsOf(*curve) : Points();
    const int rows = static_cast<int>(now.size());
    const int before = rowCount();
    if (rows == before) {
        const auto [first, last] = differingRows(std::exchange(shown_, std::move(now)), shown_);
        tellChanged(first, last);
        return;
    }
    if (rows > before) {
        beginInsertRows({}, before, rows - 1);
        shown_ = std::move(now);
        endInsertRows();
    } else {
        beginRemoveRows({}, rows, before - 1);
        shown_ = std::move(now);
        endRemoveRows();
    }
    tellChanged(0, rows - 1);
}

void PointsModel::tellChanged(int first, int last) {
    if (first <= last)
        Q_EMIT dataChanged(index(first, 0), index(last, columnCount() - 1));
}

void PointsModel::retranslate() {
    tellChanged(0, rowCount() - 1);
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

int PointsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kOwnColumns + static_cast<int>(columns_.size());
}

Point PointsModel::pointAt(int row) const {
    return kriva::pointAt(*editor_.activeCurve(), row);
}

QVariant PointsModel::data(const QModelIndex& index, int role) const {
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (!index.isValid() || (role != Qt::DisplayRole && role != Qt::EditRole && role != Qt::ToolTipRole))
        return {};
    const Curve* curve = editor_.activeCurve();
    if (!curve || index.row() >= static_cast<int>(pointCount(*curve)))
        return {}; // a view asks for the last time, about to hear that the row is gone
    if (index.column() >= kOwnColumns)
        return columns_[ownColumn(index.column())].text(*curve, index.row());
    const Point point = pointAt(index.row());
    const double number = index.column() == kX ? point.x : point.y;
    switch (role) {
    case Qt::EditRole:
        return number;
    case Qt::ToolTipRole:
        return formatNumber(number);
    default:
        return shownNumber(number, kDigits);
    }
}

bool PointsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || role != Qt::EditRole)
        return false;
    if (index.column() >= kOwnColumns) {
        const PointColumn& column = columns_[ownColumn(index.column())];
        std::optional<Curve> changed = column.withText(*editor_.activeCurve(), index.row(), value.toString());
        if (changed)
            editor_.change(std::move(*changed), column.step);
        return changed.has_value();
    }
    Point point = pointAt(index.row());
    (index.column() == kX ? point.x : point.y) = value.toDouble();
    editor_.placePoint(index.row(), point);
    return true;
}

QVariant PointsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole)
        return {};
    if (orientation == Qt::Vertical)
        return section;
    if (section >= kOwnColumns)
        return QCoreApplication::translate("PointColumn", columns_[ownColumn(section)].title);
    return section == kX ? QStringLiteral("x") : QStringLiteral("y");
}

Qt::ItemFlags PointsModel::flags(const QModelIndex& index) const {
    return QAbstractTableModel::flags(index) | Qt::ItemIsEditable;
}

} // namespace kriva::ui
