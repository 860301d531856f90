#include "core/exchange/conversion.h"

namespace kriva {

Curve converted(const Curve& curve, SheetIndex sheet) {
    if (curve.index() == sheet)
        return curve;
    const Curve fresh = withStyle(renamed(emptyCurve(sheet), nameOf(curve)), styleOf(curve));
    return withPointsAdded(fresh, pointsOf(curve));
}

Points pointsOf(const Curve& curve) {
    Points points;
    points.reserve(pointCount(curve));
    for (std::size_t i = 0; i < pointCount(curve); ++i)
        points.push_back(pointAt(curve, static_cast<int>(i)));
    return points;
}

} // namespace kriva
