#include "core/sheets/subdivision/subdivision.h"

#include "core/bezier/evaluate.h"

#include <numeric>

namespace kriva {

std::size_t controlPointCount(const SubdivisionCurve& curve) {
    return std::accumulate(curve.multiplicity.begin(), curve.multiplicity.end(), std::size_t{0},
                           [](std::size_t sum, int times) { return sum + static_cast<std::size_t>(times); });
}

Points controlPolygon(const SubdivisionCurve& curve) {
    Points polygon;
    polygon.reserve(controlPointCount(curve));
    for (std::size_t i = 0; i < curve.points.size(); ++i)
        polygon.insert(polygon.end(), static_cast<std::size_t>(curve.multiplicity[i]), curve.points[i]);
    return polygon;
}

Subdivision subdivide(const SubdivisionCurve& curve) {
    Subdivision result;
    result.polygon = controlPolygon(curve);
    result.triangle = deCasteljau(result.polygon, curve.t);
    result.halves = split(result.polygon, curve.t);
    result.derivative = derivative(result.polygon, curve.t);
    if (curve.blossom)
        result.blossom = blossom(result.polygon, *curve.blossom);
    return result;
}

std::vector<Points> pieces(const SubdivisionCurve& curve) {
    return pieces(controlPolygon(curve), curve.t, curve.levels);
}

} // namespace kriva
