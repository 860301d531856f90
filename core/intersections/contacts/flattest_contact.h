#pragma once

#include "core/intersections/contacts/arc.h"

#include <cstdint>

namespace kriva {

/// How many times farther than the stretch on which arcs seem to touch the order of their contact shows clearly.
inline constexpr double kReach = 4;

/// What it takes to find it out: some series and feet of perpendiculars.
inline constexpr std::uint64_t kStepsOfTouching = 480;

/// The place near a contact where the two segments are flattest against each other: where their gap has an inner
/// multiple root, as seen from the distance `reach` (in the parameter of a), or the root itself if it is simple.
[[nodiscard]] Contact flattestContact(const Arc& a, const Arc& b, Contact near, double reach);

} // namespace kriva
