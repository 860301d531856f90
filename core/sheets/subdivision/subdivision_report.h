#pragma once

#include "core/budget/work_budget.h"
#include "core/curve/file_error.h"
#include "core/curve/json/json_writer.h"
#include "core/curve/output.h"
#include "core/curve/results.h"
#include "core/sheets/subdivision/subdivision.h"

namespace kriva {

/// How many points its report lists of the scheme at t: all control points and what comes of them.
[[nodiscard]] std::size_t reportedSchemePoints(const SubdivisionCurve& curve);
/// Those of all curves, where the report lists them.
[[nodiscard]] std::optional<FileError> outputLimitError(std::span<const SubdivisionCurve* const> curves, Output output);
/// The members of a complete curve in the report, after its name.
void reportCurve(JsonWriter& json, const SubdivisionCurve& curve);
/// The same numbers as rows for people; of the scheme what it ends in, of the pieces their number.
[[nodiscard]] std::optional<std::vector<Result>> results(const SubdivisionCurve& curve, WorkBudget& budget);

} // namespace kriva
