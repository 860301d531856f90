#pragma once

#include "core/budget/work_budget.h"
#include "core/curve/json/json_writer.h"
#include "core/curve/results.h"
#include "core/sheets/elevation/elevation.h"

namespace kriva {

/// How many segments its report lists: they are limited over the whole sheet. Only splines have any.
[[nodiscard]] inline std::size_t reportedSegments(const ElevationCurve&) {
    return 0;
}
/// The members of a complete curve in the report, after its name.
void reportCurve(JsonWriter& json, const ElevationCurve& curve);
/// The same numbers as rows for people.
[[nodiscard]] std::optional<std::vector<Result>> results(const ElevationCurve& curve, WorkBudget& budget);

} // namespace kriva
