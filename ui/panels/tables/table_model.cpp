#include "ui/panels/tables/table_model.h"

#include "ui/figures/caption_text.h"
#include "ui/panels/result_text.h"

#include <QFont>

#include <utility>

namespace kriva::ui {
namespace {

constexpr int kShownDigits = 7;
constexpr int kFullDigits = 17;

[[nodiscard]] QString nameOf(const TableColumn& column) {
    const QString index = QString::fromStdString(column.index);
    if (column.caption == Caption::none)
        return indexed(QString::fromStdString(column.letter), index);
    return index.isEmpty() ? captionText(column.caption) : captionText(column.caption) + QLatin1Char(' ') + index;
}

[[nodiscard]] bool isEmpty(const TableCell& cell) {
    return std::holds_alternative<std::monostate>(cell.value);
}

[[nodiscard]] QString textOf(const TableCell& cell, int digits) {
    return std::visit(
        [digits]<class Value>(const Value& value) {
            if constexpr (std::is_same_v<Value, std::monostate>)
                return QString();
            else if constexpr (std::is_same_v<Value, IndexRange>)
                return QStringLiteral("%1–%2").arg(value.first).arg(value.last);
            else
                return valueText(Result::Value(value), digits);
        },
        cell.value);
}

[[nodiscard]] bool isWord(const TableCell& cell) {
    return std::holds_alternative<IndexRange>(cell.value) || std::holds_alternative<Caption>(cell.value);
}

} // namespace

void TableModel::setTable(Table table) {
    const bool hasSameShape = table.columns == table_.columns && table.rows.size() == table_.rows.size();
    if (!hasSameShape)
        beginResetModel();
    table_ = std::move(table);
    if (!hasSameShape)
        endResetModel();
    else if (rowCount() > 0)
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

void TableModel::retranslate() {
    beginResetModel();
    endResetModel();
}

int TableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(table_.rows.size());
}

int TableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(table_.columns.size());
}

QVariant TableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid())
        return {};
    const TableCell& cell =
        table_.rows[static_cast<std::size_t>(index.row())][static_cast<std::size_t>(index.column())];
    switch (role) {
    case Qt::DisplayRole:
        return textOf(cell, kShownDigits);
    case Qt::ToolTipRole:
        return textOf(cell, kFullDigits);
    case Qt::TextAlignmentRole:
        return QVariant((isWord(cell) ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    case Qt::FontRole: {
        QFont font;
        font.setBold(cell.isBest);
        return font;
    }
    default:
        return {};
    }
}

std::optional<Point> TableModel::place(const QModelIndex& index) const {
    const TableCell& cell =
        table_.rows[static_cast<std::size_t>(index.row())][static_cast<std::size_t>(index.column())];
    const Point* place = std::get_if<Point>(&cell.value);
    return place ? std::optional(*place) : std::nullopt;
}

QString TableModel::sumText(int row) const {
    if (!table_.sum || row < 0 || row >= rowCount())
        return {};
    const std::vector<TableCell>& cells = table_.rows[static_cast<std::size_t>(row)];
    QStringList terms;
    for (const auto& [number, point] : table_.sum->terms)
        if (!isEmpty(cells[number]) && !isEmpty(cells[point]))
            terms.append(
                QStringLiteral("%1 · %2").arg(textOf(cells[number], kShownDigits), textOf(cells[point], kShownDigits)));
    const std::string& letter = table_.columns[table_.sum->column].letter;
    return QStringLiteral("%1 = %2 = %3")
        .arg(indexed(QString::fromStdString(letter), QString::number(row)), terms.join(QStringLiteral(" + ")),
             textOf(cells[table_.sum->column], kShownDigits));
}

QVariant TableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole || orientation != Qt::Horizontal)
        return {};
    return nameOf(table_.columns[static_cast<std::size_t>(section)]);
}

} // namespace kriva::ui
