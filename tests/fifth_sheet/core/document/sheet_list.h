#pragma once

#include "core/sheets/combined/combined.h"
#include "core/sheets/elevation/elevation.h"
#include "core/sheets/offset/offset.h"
#include "core/sheets/spline/spline.h"
#include "core/sheets/subdivision/subdivision.h"

#include <variant>

namespace kriva {

/// The list of core with one more kind at its end.
using CurveKinds = std::variant<ElevationCurve, SubdivisionCurve, SplineCurve, CombinedCurve, OffsetCurve>;

} // namespace kriva
