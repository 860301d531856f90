#pragma once

#include "core/curve/editing/grip.h"
#include "core/figure/figure.h"

#include <vector>

namespace kriva {

/// What is drawn of a curve, and what of it can be taken hold of.
struct DrawnCurve {
    Figure figure;
    std::vector<Grip> grips;
};

} // namespace kriva
