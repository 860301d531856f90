#include "core/bezier/evaluate.h"
#include "core/figure/labels.h"
#include "core/sheets/subdivision/subdivision.h"

namespace kriva {
namespace {

/// Row i holds what stands from b_i on: b_i itself and the points between it and those behind it.
Table schemeTable(Caption caption, const Triangle& triangle) {
    Table table{caption, {{Caption::none, "i", ""}}, {}};
    for (std::size_t level = 0; level < triangle.size(); ++level)
        table.columns.push_back({translatable("Caption", "Level"), "", decimal(static_cast<int>(level))});
    for (std::size_t i = 0; i < triangle.size(); ++i) {
        std::vector<TableCell>& row = table.rows.emplace_back(table.columns.size());
        row[0].value = static_cast<int>(i);
        for (std::size_t level = 0; level + i < triangle.size(); ++level)
            row[level + 1].value = triangle[level][i];
    }
    return table;
}

Table weightsTable(std::span<const Point> polygon, double t) {
    Table table{
        Caption::weightsAtT,
        {{Caption::none, "i", ""}, {translatable("Caption", "Control point")}, {translatable("Caption", "Weight")}},
        {}};
    const std::vector<double> weights = bernstein(static_cast<int>(polygon.size()) - 1, t);
    for (std::size_t i = 0; i < polygon.size(); ++i)
        table.rows.push_back({{static_cast<int>(i)}, {polygon[i]}, {weights[i]}});
    return table;
}

Table halvesTable(const Halves& halves) {
    Table table{
        Caption::leftAndRight, {{Caption::none, "i", ""}, {Caption::none, "l", "i"}, {Caption::none, "r", "i"}}, {}};
    for (std::size_t i = 0; i < halves.left.size(); ++i)
        table.rows.push_back({{static_cast<int>(i)}, {halves.left[i]}, {halves.right[i]}});
    return table;
}

} // namespace

std::optional<std::vector<Table>> tablesOf(const SubdivisionCurve& curve, WorkBudget& budget) {
    if (isIncomplete(curve))
        return std::vector<Table>();
    const Subdivision subdivision = subdivide(curve);
    if (!budget.spend())
        return {};
    std::vector<Table> tables{schemeTable(Caption::construction, subdivision.triangle),
                              weightsTable(subdivision.polygon, curve.t), halvesTable(subdivision.halves)};
    if (curve.blossom)
        tables.push_back(schemeTable(Caption::blossom, deCasteljau(subdivision.polygon, *curve.blossom)));
    return tables;
}

} // namespace kriva
