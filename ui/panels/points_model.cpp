#include "ui/panels/points_model.h"

#include "ui/sheets/sheet_editor.h"
#include "ui/shell/language/number_text.h"

#include <QCoreApplication>
#include <QLocale>

namespace kriva::ui {
namespace {

constexpr int kOwnColumns = 2; // x and y

/// As much as a narrow column shows; the editor and the tooltip give every digit.
QString rounded(double number) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(number, 'g', 6);
}

std::size_t ownColumn(int column) {
    return static_cast<std::size_t>(column - kOwnColumns);
}

} // namespace

PointsModel::PointsModel(SheetEditor& editor, std::vector<PointColumn> columns, QObject* parent)
    : QAbstractTableModel(parent)
    , editor_(editor)
    , columns_(std::move(columns)) {
    connect(&editor.document(), &OpenDocument::replaced, this, &PointsModel::follow);
    const auto ifMine = [this](SheetIndex sheet) {
        if (sheet == editor_.index())
            follow();
    };
    connect(&editor.document(), &OpenDocument::curvesChanged, this, ifMine);
    connect(&editor.document(), &OpenDocument::viewChanged, this, ifMine);
    connect(&editor.document(), &OpenDocument::curveChanged, this, ifMine);
    follow();
}

void PointsModel::follow() {
    const Curve* curve = editor_.activeCurve();
    const int rows = curve ? static_cast<int>(pointCount(*curve)) : 0;
    if (rows > rows_) {
        beginInsertRows({}, rows_, rows - 1);
        rows_ = rows;
        endInsertRows();
    } else if (rows < rows_) {
        beginRemoveRows({}, rows, rows_ - 1);
        rows_ = rows;
        endRemoveRows();
    }
    retranslate();
}

void PointsModel::retranslate() {
    if (rows_ > 0)
        Q_EMIT dataChanged(index(0, 0), index(rows_ - 1, columnCount() - 1));
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
        return rounded(number);
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
