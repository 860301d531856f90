#include "core/intersections/contacts/arc.h"

#include "core/bezier/subdivide.h"

#include <cassert>

namespace kriva {
namespace {

/// Directions that are closer to parallel than this may be so by rounding.
constexpr double kDirectionNoise = 1e-9;

void measure(Arc& arc) {
    arc.box = boxOf(arc.polygon());
}

/// Where the points lie along a direction that is not of unit length.
struct Extent {
    double low;
    double high;
};

Extent extentOf(const Arc& arc, Point origin, Vector direction) {
    Extent extent{dot(direction, arc.front() - origin), 0};
    extent.high = extent.low;
    for (std::size_t i = 1; i <= arc.degree; ++i) {
        const double at = dot(direction, arc.points[i] - origin);
        extent.low = std::min(extent.low, at);
        extent.high = std::max(extent.high, at);
    }
    return extent;
}

bool areApartAlong(const Arc& a, const Arc& b, Vector direction, double gap) {
    const Extent one = extentOf(a, a.front(), direction);
    const Extent other = extentOf(b, a.front(), direction);
    return one.low - other.high > gap || other.low - one.high > gap;
}

} // namespace

Arc arcOf(std::span<const Point> segment, const ArcFrame& frame) {
    assert(segment.size() >= 2 && segment.size() <= Arc::kMostDegree + 1);
    Arc arc;
    arc.degree = segment.size() - 1;
    for (std::size_t i = 0; i <= arc.degree; ++i)
        arc.points[i] = Point{} + (segment[i] - frame.origin) / frame.unit;
    measure(arc);
    return arc;
}

ArcHalves halved(const Arc& arc) {
    const double middle = arc.from / 2 + arc.to / 2;
    ArcHalves halves{arc, arc};
    halves.left.to = middle;
    halves.right.from = middle;
    auto& row = halves.right.points;
    for (std::size_t r = 1; r <= arc.degree; ++r) {
        for (std::size_t i = 0; i <= arc.degree - r; ++i)
            row[i] = midpoint(row[i], row[i + 1]);
        halves.left.points[r] = row[0];
    }
    measure(halves.left);
    measure(halves.right);
    return halves;
}

Arc part(const Arc& arc, double from, double to) {
    Arc result = arc;
    const Points points = part(arc.polygon(), from, to);
    std::ranges::copy(points, result.points.begin());
    result.from = arc.parameter(from);
    result.to = arc.parameter(to);
    measure(result);
    return result;
}

Arc reversed(const Arc& arc) {
    Arc result = arc;
    std::reverse(result.points.begin(), result.points.begin() + static_cast<std::ptrdiff_t>(arc.degree) + 1);
    std::swap(result.from, result.to);
    return result;
}

ArcPoint evaluate(const Arc& arc, double t) {
    auto row = arc.points;
    Vector velocity;
    for (std::size_t r = arc.degree; r > 0; --r) {
        if (r == 1)
            velocity = static_cast<double>(arc.degree) * (row[1] - row[0]);
        for (std::size_t i = 0; i < r; ++i)
            row[i] = lerp(row[i], row[i + 1], t);
    }
    return {row[0], velocity};
}

std::optional<TangentCone> tangentCone(const Arc& arc) {
    const Vector axis = arc.chord();
    std::optional<TangentCone> cone;
    for (std::size_t i = 0; i < arc.degree; ++i) {
        const Vector side = arc.points[i + 1] - arc.points[i];
        if (side == Vector{})
            continue;
        if (!(dot(side, axis) > 0))
            return {};
        if (!cone)
            cone = TangentCone{side, side};
        else if (cross(cone->right, side) < 0)
            cone->right = side;
        else if (cross(cone->left, side) > 0)
            cone->left = side;
    }
    return cone;
}

bool areTransversal(const TangentCone& a, const TangentCone& b) {
    const auto turn = [](Vector u, Vector v) {
        const double sine = cross(u, v);
        const double noise = kDirectionNoise * std::sqrt(dot(u, u) * dot(v, v));
        return sine > noise ? 1 : sine < -noise ? -1 : 0;
    };
    const int first = turn(a.right, b.right);
    return first != 0 && turn(a.right, b.left) == first && turn(a.left, b.right) == first &&
           turn(a.left, b.left) == first;
}

bool areApart(const Arc& a, const Arc& b, double gap) {
    for (const Vector along : {a.chord(), b.chord()}) {
        const double scaled = gap * std::sqrt(dot(along, along));
        if (areApartAlong(a, b, {-along.y, along.x}, scaled) || areApartAlong(a, b, along, scaled))
            return true;
    }
    return false;
}

} // namespace kriva
