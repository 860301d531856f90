#include "core/intersections/chain_links.h"

#include <algorithm>

namespace kriva {

bool isOnePoint(std::span<const Point> segment) {
    return std::ranges::all_of(segment, [&](Point p) { return p == segment.front(); });
}

std::vector<std::optional<std::size_t>> followers(const SegmentChain& chain) {
    const std::size_t count = chain.segments.size();
    std::vector<std::optional<std::size_t>> after(count);
    std::optional<std::size_t> next;
    // Backwards, a closed chain twice, so that its end knows its start.
    for (std::size_t round = 0; round < (chain.closed ? 2 : 1); ++round)
        for (std::size_t i = count; i-- > 0;) {
            after[i] = next;
            if (!isOnePoint(chain.segments[i]))
                next = i;
        }
    return after;
}

} // namespace kriva
