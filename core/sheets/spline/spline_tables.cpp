#include "core/figure/labels.h"
#include "core/sheets/spline/spline.h"
#include "core/sheets/spline/spline_measures.h"

#include <array>

namespace kriva {
namespace {

Table coefficientsTable(const SplineCurve& curve, WorkBudget& budget) {
    Table table{Caption::coefficients, {{translatable("Caption", "Segment")}}, {}};
    for (int k = 0; k <= curve.degree; ++k)
        table.columns.push_back({Caption::none, "B", decimal(k)});
    for (const Points& segment : segmentsOf(curve)) {
        if (!budget.spend())
            break;
        std::vector<TableCell>& row = table.rows.emplace_back();
        row.push_back({static_cast<int>(table.rows.size()) - 1});
        for (const Vector coefficient : powerCoefficients(segment))
            row.push_back({coefficient});
    }
    return table;
}

TableCell cellOf(std::optional<double> value) {
    return value ? TableCell{*value} : TableCell{};
}

/// All knots take their handles from the rule, or there would be nothing to compare.
Table rulesTable(const SplineCurve& curve, WorkBudget& budget) {
    Table table{Caption::allRules,
                {{translatable("Caption", "Rule")},
                 {Caption::length},
                 {Caption::bendingEnergy},
                 {translatable("Caption", "Largest curvature")}},
                {}};
    SplineCurve other = curve;
    other.inner.clear();
    for (SplineKnot& knot : other.knots)
        knot = {knot.at, SplineKnot::Join::automatic, {}, {}};
    for (const NamedRule& named : kRules) {
        other.rule = named.rule;
        const std::optional<SplineMeasures> measures = measure(other, budget);
        if (!measures)
            break;
        table.rows.push_back({{named.caption},
                              {measures->length},
                              cellOf(measures->bendingEnergy),
                              cellOf(largestCurvature(other, budget))});
    }
    for (std::size_t column = 1; column < table.columns.size(); ++column)
        markLeast(table, column);
    return table;
}

} // namespace

std::optional<std::vector<Table>> tablesOf(const SplineCurve& curve, WorkBudget& budget) {
    if (isIncomplete(curve))
        return std::vector<Table>();
    std::vector<Table> tables{coefficientsTable(curve, budget)};
    if (curve.degree != 2) // of parabolas there is but one chain, whatever the rule
        tables.push_back(rulesTable(curve, budget));
    if (budget.end())
        return {};
    return tables;
}

} // namespace kriva
