#pragma once

#include "core/sheets/combined/combined.h"
#include "core/sheets/elevation/elevation.h"
#include "core/sheets/spline/spline.h"
#include "core/sheets/subdivision/subdivision.h"

#include <variant>

namespace kriva {

/// The kinds of curves in the order of their sheets. A further sheet is one more here: nothing else in core names one
/// but what compares several of them.
using CurveKinds = std::variant<ElevationCurve, SubdivisionCurve, SplineCurve, CombinedCurve>;

} // namespace kriva
