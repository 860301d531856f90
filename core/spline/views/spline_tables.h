#pragma once

#include "core/document/table.h"
#include "core/spline/spline.h"

namespace kriva {

/// The coefficients of the segments in the powers of their own t; the same knots under every rule, with the least
/// length, bending energy and curvature marked. None for incomplete curves.
[[nodiscard]] std::vector<Table> tablesOf(const SplineCurve& curve);

} // namespace kriva
