#pragma once

#include "core/sheets/combined/combined.h"
#include "core/sheets/elevation/elevation.h"
#include "core/sheets/spline/spline.h"
#include "core/sheets/subdivision/subdivision.h"

#include <variant>

namespace kriva {

/// The kinds of curves in the order of their sheets. A further sheet is one more here, and nothing else in core names
/// one.
using CurveKinds = std::variant<ElevationCurve, SubdivisionCurve, SplineCurve, CombinedCurve>;

} // namespace kriva
