#include "core/curve/editing/grip.h"

namespace kriva {

std::vector<Grip> pointGrips(std::span<const Point> points) {
    std::vector<Grip> grips;
    grips.reserve(points.size());
    for (const Point p : points)
        grips.push_back({{GripKind::point, static_cast<int>(grips.size())}, p});
    return grips;
}

Points withPointsMoved(const Points& points, std::span<const GripId> ids, Vector by) {
    Points moved = points;
    for (const GripId& id : ids) {
        const auto index = static_cast<std::size_t>(id.index);
        if (id.kind == GripKind::point && index < points.size())
            moved[index] = points[index] + by; // from the old value: a grip named twice moves once
    }
    return moved;
}

} // namespace kriva
