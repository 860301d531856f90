#include "core/bezier/straight.h"

#include <algorithm>
#include <cassert>

namespace kriva {

double polygonLength(std::span<const Point> points) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        sum += distance(points[i], points[i + 1]);
    return sum;
}

bool isStraight(std::span<const Point> curve) {
    assert(!curve.empty());
    const Point start = curve.front();
    const auto farthest = std::ranges::max_element(curve, {}, [&](Point p) { return distance(start, p); });
    const double reach = distance(start, *farthest);
    if (reach == 0)
        return true;
    const Vector direction = (*farthest - start) / reach;
    const double allowed = 1e-9 * polygonLength(curve);
    return std::ranges::all_of(curve, [&](Point p) { return std::abs(cross(direction, p - start)) <= allowed; });
}

} // namespace kriva
