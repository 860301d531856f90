#pragma once

#include "core/combined/combined_curve.h"
#include "core/document/table.h"

namespace kriva {

/// The runs with their polynomials in the chosen basis and their residuals; the joins with their control points. None
/// for incomplete curves.
[[nodiscard]] std::vector<Table> tablesOf(const CombinedCurve& curve);

} // namespace kriva
