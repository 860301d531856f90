#include "ui/panels/points_model.h"

#include "core/document/conversion.h"
#include "ui/base/language/number_text.h"
#include "ui/editing/sheet_editor.h"

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

/// The first and the last row with another point; all, the new one too, where no point differs: then something else
/// does.
std::pair<int, int> differingRows(const Points& before, const Points& now) {
    const auto first = std::ranges::mismatch(before, now).in1 - before.begin();
    if (first == std::ssize(before))
        return {0, static_cast<int>(first)};
    const auto last = before.rend() - std::mismatch(before.rbegin(), before.rend(), now.rbegin()).first - 1;
    return {static_cast<int>(first), static_cast<int>(last)};
}

} // namespace

PointsModel::PointsModel(SheetEditor& editor, std::vector<PointColumn> columns, QObject* parent)
    : QAbstractTableModel(parent)
    , editor_(editor)
    , columns_(std::move(columns))
    , serial_(editor.activeSerial()) {
    // Another curve may have the same points with other joins. What was begun for a curve is no point of another one.
    const auto followAll = [this] {
        const Serial active = editor_.activeSerial();
        const bool isOther = std::exchange(serial_, active) != active;
        if (isOther)
            clearDraft();
        follow();
        if (isOther && !isAddingDraft_)
            Q_EMIT otherCurveShown();
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
    const int before = pointRows();
    if (rows == before) {
        const auto [first, last] = differingRows(std::exchange(shown_, std::move(now)), shown_);
        tellChanged(first, last);
        return;
    }
    if (rows > before) {
        // The new row stays the last one, with whoever is typing in it, unless it is what becomes a point.
        const int first = isAddingDraft_ ? before + 1 : before;
        beginInsertRows({}, first, first + rows - before - 1);
        shown_ = std::move(now);
        endInsertRows();
    } else {
        beginRemoveRows({}, rows, before - 1);
        shown_ = std::move(now);
        endRemoveRows();
    }
    tellChanged(0, rows);
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
    if (!index.isValid())
        return {};
    if (index.row() == newRow())
        return draftData(index.column(), role);
    if (role != Qt::DisplayRole && role != Qt::EditRole && role != Qt::ToolTipRole)
        return {};
    const Curve* curve = editor_.activeCurve();
    if (!curve || index.row() >= static_cast<int>(pointCount(*curve)))
        return {}; // a view asks for the last time, about to hear that the row is gone
    if (index.column() >= kOwnColumns)
        return columns_[ownColumn(index.column())].text(*curve, index.row());
    const Point point = pointAt(index.row());
    return coordinateData(index.column() == kX ? point.x : point.y, role);
}

QVariant PointsModel::draftData(int column, int role) const {
    if (role == Qt::AccessibleTextRole || role == Qt::AccessibleDescriptionRole || role == Qt::ToolTipRole)
        return tr("New point");
    const std::optional<double> number = column < kOwnColumns ? draft_[static_cast<std::size_t>(column)] : std::nullopt;
    return number ? coordinateData(*number, role) : QVariant();
}

QVariant PointsModel::coordinateData(double number, int role) const {
    if (role == Qt::EditRole)
        return number;
    if (role == Qt::ToolTipRole)
        return formatNumber(number);
    return role == Qt::DisplayRole ? QVariant(shownNumber(number, kDigits)) : QVariant();
}

bool PointsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || role != Qt::EditRole || !flags(index).testFlag(Qt::ItemIsEditable))
        return false;
    if (index.row() == newRow()) {
        draft_[static_cast<std::size_t>(index.column())] = value.toDouble();
        addDraft();
        return true;
    }
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

/// Where the sheet refuses it, the row keeps what was typed.
void PointsModel::addDraft() {
    if (!draft_[kX] || !draft_[kY])
        return tellChanged(newRow(), newRow());
    const auto kept = std::exchange(draft_, {});
    isAddingDraft_ = true;
    const bool isAdded = editor_.addPoint({*kept[kX], *kept[kY]});
    isAddingDraft_ = false;
    if (isAdded) {
        Q_EMIT pointAdded();
        return;
    }
    draft_ = kept;
    tellChanged(newRow(), newRow());
}

void PointsModel::clearDraft() {
    if (std::exchange(draft_, {}) != decltype(draft_)())
        tellChanged(newRow(), newRow());
}

bool PointsModel::accepts(const QModelIndex& index, const QString& text) const {
    const Curve* curve = editor_.activeCurve();
    return curve && index.isValid() && index.row() < newRow() &&
           columns_[ownColumn(index.column())].withText(*curve, index.row(), text).has_value();
}

QString PointsModel::needed(const QModelIndex& index) const {
    const Curve* curve = editor_.activeCurve();
    return curve && index.isValid() && index.row() < newRow()
               ? columns_[ownColumn(index.column())].needed(*curve, index.row())
               : QString();
}

QVariant PointsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical && section == newRow()) {
        if (role == Qt::AccessibleTextRole || role == Qt::ToolTipRole)
            return tr("New point");
        return role == Qt::DisplayRole ? QVariant(QStringLiteral("+")) : QVariant();
    }
    if (role != Qt::DisplayRole)
        return {};
    if (orientation == Qt::Vertical)
        return section;
    if (section >= kOwnColumns)
        return QCoreApplication::translate("PointColumn", columns_[ownColumn(section)].title);
    return section == kX ? QStringLiteral("x") : QStringLiteral("y");
}

Qt::ItemFlags PointsModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags known = QAbstractTableModel::flags(index);
    if (!index.isValid() || index.row() < newRow())
        return known | Qt::ItemIsEditable;
    // There is no point to select yet, nor anything of it but its place.
    const Qt::ItemFlags unselectable = known & ~Qt::ItemFlags(Qt::ItemIsSelectable);
    return index.column() < kOwnColumns ? unselectable | Qt::ItemIsEditable : unselectable;
}

} // namespace kriva::ui
