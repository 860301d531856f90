#include "core/polynomial/shape.h"

#include <cassert>

namespace kriva {

Points shapeOf(std::span<const WideVector> fromStart) {
    assert(!fromStart.empty());
    const Vector way = fromStart.back().vector();
    const double distance = length(way);
    const Vector ahead = distance > 0 ? way / distance : Vector{1, 0};
    Points shape;
    shape.reserve(fromStart.size());
    for (const WideVector& v : fromStart)
        shape.push_back({(v.x * ahead.x + v.y * ahead.y).high, (v.y * ahead.x - v.x * ahead.y).high});
    return shape;
}

} // namespace kriva
