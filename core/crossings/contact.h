#pragma once

#include "core/crossings/arc.h"

namespace kriva {

/// A place where two arcs meet, by the parameters of their segments.
struct Contact {
    double a = 0;
    double b = 0;
    friend constexpr bool operator==(const Contact&, const Contact&) = default;
};

} // namespace kriva
