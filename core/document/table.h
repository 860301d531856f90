#pragma once

#include "core/figure/caption.h"
#include "core/geometry/point.h"

#include <string>
#include <variant>
#include <vector>

/// Tables of numbers as plain values, for the Tables panel, spreadsheets and LaTeX.
namespace kriva {

/// From one index to another, both included.
struct IndexRange {
    int first = 0;
    int last = 0;
    friend bool operator==(const IndexRange&, const IndexRange&) = default;
};

/// Nothing where there is no number to show.
struct TableCell {
    std::variant<std::monostate, double, int, IndexRange, Caption, Point> value;
    bool isBest = false; ///< of its column
    friend bool operator==(const TableCell&, const TableCell&) = default;
};

/// A column's name: a caption, or a letter with an index.
struct TableColumn {
    Caption caption = Caption::none;
    std::string letter = {};
    std::string index = {};
    friend bool operator==(const TableColumn&, const TableColumn&) = default;
};

struct Table {
    Caption caption = Caption::none;
    std::vector<TableColumn> columns;
    std::vector<std::vector<TableCell>> rows; ///< each as long as there are columns
    friend bool operator==(const Table&, const Table&) = default;
};

/// Marks the smallest numbers of a column as the best.
void markLeast(Table& table, std::size_t column);

} // namespace kriva
