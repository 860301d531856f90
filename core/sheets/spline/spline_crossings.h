#pragma once

#include "core/budget/work_budget.h"
#include "core/curve/json/json_writer.h"
#include "core/curve/limits.h"
#include "core/curve/relations.h"
#include "core/intersections/crossings.h"
#include "core/sheets/spline/chain/spline.h"

namespace kriva {

/// How the curves of a sheet meet; those still being drawn take no part. Nothing where the budget has ended, which it
/// does as WorkEnd::tooMuchFound beyond so many passes.
[[nodiscard]] std::optional<Crossings> crossingsOf(std::span<const SplineCurve* const> curves, WorkBudget& budget,
                                                   std::size_t mostPasses = limits::kPasses);

/// The members of the sheet in the report after its curves; why there are none where the budget has ended.
[[nodiscard]] std::optional<FileError> reportTogether(JsonWriter& json, std::span<const SplineCurve* const> curves,
                                                      WorkBudget& budget);

/// The same for people: how many crossings and where, and marks for those of curves that are shown. Nothing where the
/// budget was stopped.
[[nodiscard]] std::optional<Relations> relationsOf(std::span<const SplineCurve* const> curves, WorkBudget& budget);
/// What they are where the search ended without being stopped: the reason, for people and for files.
[[nodiscard]] Relations refusedRelations(WorkEnd end);

} // namespace kriva
