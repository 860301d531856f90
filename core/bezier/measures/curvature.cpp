#include "core/bezier/measures/curvature.h"

#include "core/bezier/evaluate.h"

#include <algorithm>
#include <cassert>

namespace kriva {

std::optional<double> curvature(std::span<const Point> curve, double t) {
    const Vector velocity = derivative(curve, t);
    const double speed = length(velocity);
    if (speed == 0)
        return std::nullopt;
    // Divided step by step: the cube of a tiny speed would vanish.
    return cross(velocity / speed, secondDerivative(curve, t) / speed) / speed;
}

std::optional<Vector> startTangent(std::span<const Point> curve) {
    assert(!curve.empty());
    const auto next = std::ranges::find_if(curve, [&](Point p) { return p != curve.front(); });
    if (next == curve.end())
        return std::nullopt;
    const Vector towards = *next - curve.front();
    return towards / length(towards);
}

std::optional<Vector> endTangent(std::span<const Point> curve) {
    const Points reversed(curve.rbegin(), curve.rend());
    const auto tangent = startTangent(reversed);
    return tangent ? std::optional(-*tangent) : std::nullopt;
}

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
