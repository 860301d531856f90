#include "core/io/svg/paths/elliptical_arc.h"

#include "core/geometry/affine.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kriva {
namespace {

/// An arc of the unit circle, and the map that makes the ellipse of it.
struct CircleArc {
    Affine map;
    double start = 0; ///< radians
    double sweep = 0;
};

double angleOf(Vector v) {
    return std::atan2(v.y, v.x);
}

CircleArc onCircle(const EllipticalArc& arc, Point from, Point to) {
    constexpr double kTurn = 2 * std::numbers::pi;
    const double angle = arc.rotation * std::numbers::pi / 180;
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    double rx = std::abs(arc.radiusX);
    double ry = std::abs(arc.radiusY);
    const Vector half = 0.5 * (from - to);
    // Radii that do not even span the chord are enlarged at once, so that nothing overflows below.
    const double least = length(half) / std::max(rx, ry);
    if (least > 1) {
        rx *= least;
        ry *= least;
    }
    // Half of the chord in the ellipse's own axes, where the ellipse is the unit circle.
    Vector onUnit{(cosine * half.x + sine * half.y) / rx, (cosine * half.y - sine * half.x) / ry};
    const double reach = length(onUnit);
    if (reach > 1) {
        rx *= reach;
        ry *= reach;
        onUnit = onUnit / reach;
    }
    const double toChord = std::sqrt(std::max(0.0, 1 - dot(onUnit, onUnit)));
    const double side = arc.isLarge == arc.isPositive ? -1 : 1;
    const double chord = std::max(length(onUnit), 1e-300);
    const Vector centre = side * toChord / chord * Vector{onUnit.y, -onUnit.x};
    CircleArc result;
    const Affine axes{rx * cosine, rx * sine, -ry * sine, ry * cosine, 0, 0};
    const Point middle = midpoint(from, to);
    const Point shift = axes({centre.x, centre.y});
    result.map = translation({middle.x + shift.x, middle.y + shift.y}) * axes;
    result.start = angleOf(onUnit - centre);
    result.sweep = angleOf(-onUnit - centre) - result.start;
    if (arc.isPositive && result.sweep < 0)
        result.sweep += kTurn;
    else if (!arc.isPositive && result.sweep > 0)
        result.sweep -= kTurn;
    return result;
}

} // namespace

bool isLine(const EllipticalArc& arc) {
    constexpr double kFlat = 1e-12; // of the larger radius: flatter than doubles tell
    const double rx = std::abs(arc.radiusX);
    const double ry = std::abs(arc.radiusY);
    return std::min(rx, ry) <= kFlat * std::max(rx, ry);
}

namespace {

/// A bound of the distance of the usual cubic from an arc of so much of the unit circle.
double deviationOf(double sweep) {
    const double s = std::sin(sweep / 4);
    const double c = std::cos(sweep / 4);
    return 2.0 / 27 * s * s * s * s * s * s / (c * c);
}

} // namespace

std::vector<std::array<Point, 4>> cubicsOf(const EllipticalArc& arc, Point from, Point to) {
    if (from == to || isLine(arc))
        return {};
    const CircleArc circle = onCircle(arc, from, to);
    int count = std::max(1, static_cast<int>(std::ceil(std::abs(circle.sweep) / (std::numbers::pi / 2) - 1e-9)));
    while (deviationOf(std::abs(circle.sweep) / count) > kArcTolerance)
        ++count;
    const double step = circle.sweep / count;
    const double arm = 4.0 / 3 * std::tan(step / 4);
    std::vector<std::array<Point, 4>> cubics;
    for (int i = 0; i < count; ++i) {
        const double a = circle.start + i * step;
        const double b = circle.start + (i + 1) * step;
        const Point start{std::cos(a), std::sin(a)};
        const Point end{std::cos(b), std::sin(b)};
        const Point first = start + arm * Vector{-start.y, start.x};
        const Point second = end - arm * Vector{-end.y, end.x};
        cubics.push_back({cubics.empty() ? from : cubics.back()[3], circle.map(first), circle.map(second),
                          i + 1 < count ? circle.map(end) : to});
    }
    return cubics;
}

} // namespace kriva
