#pragma once

#include "core/geometry/point.h"
#include "core/numbers/lanes.h"

#include <array>

namespace kriva {

/// As many places or vectors as doubles fit into a register, for work on all of them at once: see workByLanes().
struct PlaceLanes {
    Lanes x;
    Lanes y;

    /// The same one in each lane.
    [[nodiscard, gnu::always_inline]] static PlaceLanes at(Vector v) {
        PlaceLanes places;
        spread(v.x, places.x);
        spread(v.y, places.y);
        return places;
    }
    [[nodiscard, gnu::always_inline]] static PlaceLanes at(Point p) { return at(Vector{p.x, p.y}); }

    /// To as many points as there are lanes.
    [[gnu::always_inline]] void write(Point* points) const {
        const Lanes even = __builtin_shufflevector(x, y, 0, 4, 2, 6);
        const Lanes odd = __builtin_shufflevector(x, y, 1, 5, 3, 7);
        store(__builtin_shufflevector(even, odd, 0, 1, 4, 5), &points[0].x);
        store(__builtin_shufflevector(even, odd, 2, 3, 6, 7), &points[2].x);
    }
    /// Each to its own point.
    [[gnu::always_inline]] void write(const std::array<Point*, kLanes>& points) const {
        for (std::size_t k = 0; k < kLanes; ++k)
            *points[k] = {x[k], y[k]};
    }
};

[[nodiscard, gnu::always_inline]] inline PlaceLanes operator+(const PlaceLanes& a, const PlaceLanes& b) {
    return {a.x + b.x, a.y + b.y};
}
[[nodiscard, gnu::always_inline]] inline PlaceLanes operator-(const PlaceLanes& a, const PlaceLanes& b) {
    return {a.x - b.x, a.y - b.y};
}
[[nodiscard, gnu::always_inline]] inline PlaceLanes operator*(const Lanes& s, const PlaceLanes& a) {
    return {s * a.x, s * a.y};
}

} // namespace kriva
