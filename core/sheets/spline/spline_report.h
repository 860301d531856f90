#pragma once

#include "core/budget/work_budget.h"
#include "core/curve/file_error.h"
#include "core/curve/json/json_writer.h"
#include "core/curve/output.h"
#include "core/curve/results.h"
#include "core/sheets/spline/chain/spline.h"

namespace kriva {

/// Where a report would list too many segments.
[[nodiscard]] std::optional<FileError> outputLimitError(std::span<const SplineCurve* const> curves, Output output);
/// The members of a complete curve in the report, after its name.
void reportCurve(JsonWriter& json, const SplineCurve& curve);
/// The same numbers as rows for people, and the coefficients of every segment.
[[nodiscard]] std::optional<std::vector<Result>> results(const SplineCurve& curve, WorkBudget& budget);

/// The coefficients B_0..B_n of a segment in the powers of its own t, 0 to 1: B_k = C(n, k) times the k-th forward
/// difference of the control points.
[[nodiscard]] std::vector<Vector> powerCoefficients(std::span<const Point> segment);

} // namespace kriva
