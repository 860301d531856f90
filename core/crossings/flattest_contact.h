#pragma once

#include "core/crossings/contact.h"

namespace kriva {

/// The place near a contact where the two segments are flattest against each other: where their gap has an inner
/// multiple root, as seen from the distance `reach` (in the parameter of a), or the root itself if it is simple.
[[nodiscard]] Contact flattestContact(const Arc& a, const Arc& b, Contact near, double reach);

} // namespace kriva
