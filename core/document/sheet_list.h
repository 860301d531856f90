#pragma once

#include "core/sheets/combined/combined_sheet.h"
#include "core/sheets/elevation/elevation_sheet.h"
#include "core/sheets/spline/spline_sheet.h"
#include "core/sheets/subdivision/subdivision_sheet.h"

#include <variant>

namespace kriva {

/// The kinds of curves in the order of their sheets. A further sheet is one more here, and nothing else in core names
/// one.
using CurveKinds = std::variant<ElevationCurve, SubdivisionCurve, SplineCurve, CombinedCurve>;

} // namespace kriva
