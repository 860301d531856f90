#pragma once

#include "core/io/tables/table_reader.h"

#include <QString>

namespace kriva::ui {

/// Points as text for spreadsheets: two numbers in each line, in the present language, between them a tab.
[[nodiscard]] QString pointsTable(const Points& points);

/// One line that names the place in the table, in the present language.
[[nodiscard]] QString errorText(const TableError& error);

} // namespace kriva::ui
