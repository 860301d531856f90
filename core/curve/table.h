#pragma once

#include "core/figure/caption.h"
#include "core/geometry/point.h"

#include <optional>
#include <string>
#include <utility>
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

/// Nothing where there is no number to show. Points are places in the figure, vectors are not.
struct TableCell {
    std::variant<std::monostate, double, int, IndexRange, Caption, Point, Vector> value;
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

/// What a column of points is worked out by: in every row the sum of products of a number and a point. A term whose
/// cells are empty does not count.
struct WeightedSum {
    std::size_t column = 0;
    std::vector<std::pair<std::size_t, std::size_t>> terms; ///< columns of the number and of the point
    friend bool operator==(const WeightedSum&, const WeightedSum&) = default;
};

struct Table {
    Caption caption = Caption::none;
    std::vector<TableColumn> columns;
    std::vector<std::vector<TableCell>> rows; ///< each as long as there are columns
    std::optional<WeightedSum> sum = {};
    friend bool operator==(const Table&, const Table&) = default;
};

struct CellIndex {
    std::size_t row = 0;
    std::size_t column = 0;
    friend bool operator==(const CellIndex&, const CellIndex&) = default;
};

/// Where a point stands, as exactly this value: in the column of the sums if it does, else the first place row by row.
[[nodiscard]] std::optional<CellIndex> cellOf(const Table& table, Point point);

/// Marks the smallest numbers of a column as the best.
void markLeast(Table& table, std::size_t column);

} // namespace kriva
