#pragma once

#include "core/budget/work_budget.h"
#include "core/intersections/crossings.h"

namespace kriva {

/// Two passes that meet. A segment may cross itself in so small a loop that its two passes seem to be one.
struct Meeting {
    Pass one;
    Pass other;
};

/// Meetings closer to each other than the distance, in a chain, as one place with all their passes; passes that run
/// into each other without leaving the place are one. What is left of a place with one pass only is none. O(n log n)
/// where meetings in one place are closer to each other than half the distance.
[[nodiscard]] std::vector<Crossing> unitedPlaces(std::span<const SegmentChain> chains,
                                                 std::span<const Meeting> meetings, double distance,
                                                 WorkBudget& budget);

} // namespace kriva
