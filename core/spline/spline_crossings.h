#pragma once

#include "core/crossings/crossings.h"
#include "core/document/json/json_writer.h"
#include "core/document/relations.h"
#include "core/spline/spline.h"
#include "core/work/work_budget.h"

namespace kriva {

/// How the curves of a sheet meet; those still being drawn take no part.
[[nodiscard]] Crossings crossingsOf(std::span<const SplineCurve* const> curves);

/// The members of the sheet in the report after its curves.
void reportTogether(JsonWriter& json, std::span<const SplineCurve* const> curves);

/// The same for people: how many crossings and where, and marks for those of curves that are shown. Nothing where the
/// budget was stopped.
[[nodiscard]] std::optional<Relations> relationsOf(std::span<const SplineCurve* const> curves, WorkBudget& budget);

} // namespace kriva
