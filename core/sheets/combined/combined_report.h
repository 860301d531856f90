#pragma once

#include "core/budget/work_budget.h"
#include "core/curve/file_error.h"
#include "core/curve/json/json_writer.h"
#include "core/curve/output.h"
#include "core/curve/results.h"
#include "core/sheets/combined/combined_curve.h"

namespace kriva {

/// Where solving all curves would take too long, whatever is made of them.
[[nodiscard]] std::optional<FileError> outputLimitError(std::span<const CombinedCurve* const> curves, Output output);
/// The members of a complete curve in the report, after its name.
void reportCurve(JsonWriter& json, const CombinedCurve& curve);
/// The same numbers as rows for people.
[[nodiscard]] std::optional<std::vector<Result>> results(const CombinedCurve& curve, WorkBudget& budget);

} // namespace kriva
