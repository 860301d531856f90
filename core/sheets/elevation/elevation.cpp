#include "core/sheets/elevation/elevation.h"

#include "core/bezier/elevate.h"

namespace kriva {

Elevation elevate(const ElevationCurve& curve) {
    Elevation result;
    result.polygon = elevated(curve.points, curve.times);
    result.gap = elevationGap(curve.points, curve.times);
    return result;
}

} // namespace kriva
