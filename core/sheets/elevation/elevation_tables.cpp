#include "core/bezier/elevate.h"
#include "core/sheets/elevation/elevation.h"

#include <utility>

namespace kriva {

std::optional<std::vector<Table>> tablesOf(const ElevationCurve& curve, WorkBudget& budget) {
    if (isIncomplete(curve) || curve.times == 0)
        return std::vector<Table>();
    const Points before = elevated(curve.points, curve.times - 1);
    const Points after = elevated(curve.points, curve.times);
    if (!budget.spend())
        return {};
    const double degree = static_cast<double>(after.size()) - 1;
    Table table{translatable("Caption", "Points of the last elevation"),
                {{Caption::none, "i", ""},
                 {Caption::none, "i/N", ""},
                 {Caption::none, "b", "i−1"},
                 {Caption::none, "1 − i/N", ""},
                 {Caption::none, "b", "i"},
                 {Caption::none, "b′", "i"}},
                {},
                WeightedSum{5, {{1, 2}, {3, 4}}}};
    for (std::size_t i = 0; i < after.size(); ++i) {
        const double part = static_cast<double>(i) / degree;
        table.rows.push_back({{static_cast<int>(i)},
                              {part},
                              i > 0 ? TableCell{before[i - 1]} : TableCell{},
                              {1 - part},
                              i < before.size() ? TableCell{before[i]} : TableCell{},
                              {after[i]}});
    }
    return {{std::move(table)}};
}

} // namespace kriva
