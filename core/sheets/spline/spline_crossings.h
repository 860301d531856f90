#pragma once

#include "core/intersections/crossings.h"
#include "core/sheets/spline/spline.h"

namespace kriva {

/// How the curves of a sheet meet; those still being drawn take no part. Nothing where the budget has ended, which it
/// does as WorkEnd::tooMuchFound beyond so many passes.
[[nodiscard]] std::optional<Crossings> crossingsOf(std::span<const SplineCurve* const> curves, WorkBudget& budget,
                                                   std::size_t mostPasses = limits::kPasses);

/// What a sheet has of them where the search ended without being stopped: the reason, for people and for files.
[[nodiscard]] Relations refusedRelations(WorkEnd end);

} // namespace kriva
