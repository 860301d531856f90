#pragma once

#include "core/geometry/point.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace kriva {

enum class TableProblem {
    empty,
    tooManyPoints,        ///< more than limits::kPointsInSheet
    tooManyPointsInCurve, ///< more than limits::kPointsInCurve
    notTwoNumbers,        ///< in the line, nor four under the names of four columns
    noNumber,             ///< the cell
    outOfRange,           ///< the cell: beyond limits::kNumber
    mixedDecimals,        ///< the cell has another decimal sign than the cells before
};

/// Why a text is no table of points, and where. Its sentence is made where languages are known.
struct TableError {
    TableProblem problem = TableProblem::empty;
    int line = 0;     ///< from 1; 0 where it is the table as a whole
    int column = 0;   ///< of the line, from 1, which counts bytes
    std::string cell; ///< at most its first 20 characters and an ellipsis
    friend bool operator==(const TableError&, const TableError&) = default;
};

/// The points of one or more curves from a table in UTF-8: two numbers in each line, with a decimal point or comma,
/// between them a tab, a semicolon, blanks or (where no number has a decimal comma) a comma; or four under a line that
/// names them, as Kriva writes them itself: the number of a curve, that of a point, and its coordinates. Empty lines
/// are passed over, and a first line without numbers, which names the columns. Refused where a line reads otherwise,
/// a number is beyond the model's limits, both decimal signs are there, or there are more points than a curve or a
/// sheet has. Linear, and no memory but for the points.
[[nodiscard]] std::variant<std::vector<Points>, TableError> readPointsTable(std::string_view text);

} // namespace kriva
