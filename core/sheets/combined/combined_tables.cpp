#include "core/figure/labels.h"
#include "core/sheets/combined/combined.h"

#include <algorithm>

namespace kriva {
namespace {

Table runsTable(const Combined& combined) {
    Table table{Caption::runs,
                {{Caption::run}, {Caption::points}, {Caption::degree}, {Caption::residual}, {Caption::maxError}},
                {}};
    std::size_t coefficients = 0;
    std::size_t nodes = 0;
    for (const CombinedRun& run : combined.runs) {
        coefficients = std::max(coefficients, run.coefficients.size());
        nodes = std::max(nodes, run.nodes.size());
    }
    const auto addColumns = [&](const char* letter, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k)
            table.columns.push_back({Caption::none, letter, decimal(static_cast<int>(k))});
    };
    addColumns("c", coefficients);
    addColumns("x", nodes); // of Newton's and Lagrange's basis
    for (const CombinedRun& run : combined.runs) {
        std::vector<TableCell>& row = table.rows.emplace_back();
        row.push_back({static_cast<int>(table.rows.size()) - 1});
        row.push_back({IndexRange{run.points.first, run.points.last}});
        row.insert(row.end(), {{run.degree}, {run.rms}, {run.maxError}});
        for (const double coefficient : run.coefficients)
            row.push_back({coefficient});
        row.resize(table.columns.size() - nodes);
        for (const double node : run.nodes)
            row.push_back({node});
        row.resize(table.columns.size());
    }
    return table;
}

Table joinsTable(const Combined& combined) {
    constexpr std::size_t kMostPoints = 4;
    Table table{Caption::joins, {{translatable("Caption", "After run")}, {Caption::degree}}, {}};
    for (std::size_t i = 0; i < kMostPoints; ++i)
        table.columns.push_back({Caption::none, "b", decimal(static_cast<int>(i))});
    for (const CombinedJoin& join : combined.joins) {
        std::vector<TableCell>& row = table.rows.emplace_back();
        row.insert(row.end(), {{join.afterRun}, {static_cast<int>(join.points.size()) - 1}});
        for (const Point p : join.points)
            row.push_back({p});
        row.resize(table.columns.size());
    }
    return table;
}

} // namespace

std::optional<std::vector<Table>> tablesOf(const CombinedCurve& curve, WorkBudget& budget) {
    if (isIncomplete(curve))
        return std::vector<Table>();
    const std::optional<Combined> combined = combine(curve, budget);
    if (!combined)
        return {};
    std::vector<Table> tables{runsTable(*combined)};
    if (!combined->joins.empty())
        tables.push_back(joinsTable(*combined));
    return tables;
}

} // namespace kriva
