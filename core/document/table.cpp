#include "core/document/table.h"

#include <algorithm>
#include <optional>

namespace kriva {

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
