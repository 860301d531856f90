#pragma once

#include "core/geometry/point.h"

#include <QString>

#include <variant>

namespace kriva::ui {

/// Why a text is no table of points, and where.
struct TableError {
    enum class Reason {
        empty,
        tooManyPoints,
        notTwoNumbers, ///< in the line, nor four under the names of four columns
        noNumber,      ///< the cell
        outOfRange,    ///< the cell
    };
    Reason reason = Reason::empty;
    int line = 0; ///< from 1
    QString cell;
};

/// Points as text for spreadsheets: two numbers in each line, in the present language, between them a tab.
[[nodiscard]] QString pointsTable(const Points& points);

/// The points of one or more curves from a table: two numbers in each line, with a decimal point or comma, between them
/// a tab, a semicolon, blanks or (where no number has a decimal comma) a comma; or four under a line that names them,
/// as Kriva writes them itself: the number of a curve, that of a point, and its coordinates. Empty lines are passed
/// over, and a first line without numbers, which names the columns. Refused where a line reads otherwise, a number is
/// beyond the model's limits, or there are more lines than a sheet has points.
[[nodiscard]] std::variant<std::vector<Points>, TableError> readPointsTable(const QString& text);

/// One line that names the place in the table, in the present language.
[[nodiscard]] QString errorText(const TableError& error);

} // namespace kriva::ui
