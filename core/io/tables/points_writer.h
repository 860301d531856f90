#pragma once

#include "core/document/document.h"

namespace kriva {

/// The points of the shown curves of a sheet, or of one curve, as comma-separated values for programs: `curve` (its
/// index in the sheet), `point`, `x` and `y`, each number as short as brings it back bit for bit.
[[nodiscard]] std::string writePointsCsv(const Sheet& sheet, std::optional<std::size_t> curve = {});

/// Points for spreadsheets, as readPointsTable() takes them: a line for each, with a tab between its two numbers.
[[nodiscard]] std::string writePointsTable(std::span<const Point> points, std::string_view decimalSign);

} // namespace kriva
