#pragma once

#include "core/intersections/crossings.h"

#include <optional>

namespace kriva {

/// Whether all control points coincide: such a segment takes no part, its neighbours are neighbours of each other.
[[nodiscard]] bool isOnePoint(std::span<const Point> segment);

/// For each segment of a chain the one that starts where it ends, over those of one point; nothing at an open end. A
/// closed chain of one segment is followed by itself.
[[nodiscard]] std::vector<std::optional<std::size_t>> followers(const SegmentChain& chain);

} // namespace kriva
