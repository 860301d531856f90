#pragma once

#include "core/budget/work_budget.h"
#include "core/curve/json/json_writer.h"
#include "core/curve/results.h"
#include "core/sheets/elevation/elevation.h"

namespace kriva {

/// The members of a complete curve in the report, after its name.
void reportCurve(JsonWriter& json, const ElevationCurve& curve);
/// The same numbers as rows for people.
[[nodiscard]] std::optional<std::vector<Result>> results(const ElevationCurve& curve, WorkBudget& budget);

} // namespace kriva
