#pragma once

#include "core/geometry/box.h"
#include "core/sheets/combined/combined.h"

namespace kriva {

/// The measures of the whole path. They are infinite where it leaves the range of doubles.
struct PathMeasures {
    double length = 0;
    Box bounds;                          ///< those of the points where there is no piece
    double largestKink = 0;              ///< largest turn of the tangent where two pieces meet, in radians
    std::optional<double> bendingEnergy; ///< nothing where it diverges
    double slopeVariation = 0;           ///< the sum over the runs of the integral of |y''|
};

/// `points` are those of the curve that was combined.
[[nodiscard]] std::optional<PathMeasures> measure(const Combined& combined, std::span<const Point> points,
                                                  WorkBudget& budget);
[[nodiscard]] PathMeasures measure(const Combined& combined, std::span<const Point> points);

} // namespace kriva
