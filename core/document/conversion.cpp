#include "core/document/conversion.h"

namespace kriva {

Curve converted(const Curve& curve, SheetIndex sheet) {
    if (curve.index() == sheet)
        return curve;
    const Curve fresh = withStyle(renamed(emptyCurve(sheet), nameOf(curve)), styleOf(curve));
    return withPointsAdded(fresh, pointsOf(curve));
}

Points pointsOf(const Curve& curve) {
    return std::visit(
        [](const auto& c) {
            Points points(pointCount(c));
            for (std::size_t i = 0; i < points.size(); ++i)
                points[i] = pointAt(c, static_cast<int>(i));
            return points;
        },
        curve);
}

} // namespace kriva
