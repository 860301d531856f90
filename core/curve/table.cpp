#include "core/curve/table.h"

#include <algorithm>
#include <optional>

namespace kriva {
namespace {

std::optional<CellIndex> cellOf(const Table& table, Point point, std::size_t firstColumn, std::size_t endColumn) {
    for (std::size_t row = 0; row < table.rows.size(); ++row)
        for (std::size_t column = firstColumn; column < endColumn; ++column)
            if (const Point* at = std::get_if<Point>(&table.rows[row][column].value); at && *at == point)
                return CellIndex{row, column};
    return {};
}

} // namespace

std::optional<CellIndex> cellOf(const Table& table, Point point) {
    const std::optional<CellIndex> ofSums =
        table.sum ? cellOf(table, point, table.sum->column, table.sum->column + 1) : std::nullopt;
    return ofSums ? ofSums : cellOf(table, point, 0, table.columns.size());
}

void markLeast(Table& table, std::size_t column) {
    std::optional<double> least;
    for (const std::vector<TableCell>& row : table.rows)
        if (const double* value = std::get_if<double>(&row[column].value))
            least = std::min(least.value_or(*value), *value);
    for (std::vector<TableCell>& row : table.rows)
        row[column].isBest =
            least && std::holds_alternative<double>(row[column].value) && std::get<double>(row[column].value) == *least;
}

} // namespace kriva
