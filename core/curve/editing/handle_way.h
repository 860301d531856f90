#pragma once

#include "core/geometry/point.h"

#include <optional>

namespace kriva {

/// How a handle is dragged, told from where it and its knot stood when the drag began.
struct HandleWay {
    enum class Angle {
        free,
        stepped, ///< a multiple of 15 degrees around the knot
        kept,    ///< that of the beginning; any, where the handle was retracted
    };

    Vector by = {}; ///< the whole way of the pointer
    Angle angle = Angle::free;
    Vector carried = {}; ///< the part of the way on which the knot goes along
    std::optional<Vector> opposite =
        {}; ///< where the other handle is left, seen from the knot; nothing ties it as before
};

} // namespace kriva
