#pragma once

#include "core/figure/figure.h"
#include "core/geometry/point.h"

#include <optional>

namespace kriva {

/// One tooth of a curvature comb.
struct CombTooth {
    Point foot;
    Vector outwards;      ///< of length 1, to the right of the way: away from the centre where the curve turns left
    double curvature = 0; ///< signed, positive where the curve turns left, in 1/unit
};

/// The teeth of each segment at even steps of its t, both ends included, so that at a knot one tooth tells how the
/// curvature arrives and one how it leaves; nothing where the speed is zero. `shapes` are the segments for measuring
/// (see shapesOf), `steps` at least 1. Linear in the teeth.
using CombTeeth = std::vector<std::vector<std::optional<CombTooth>>>;
[[nodiscard]] CombTeeth combTeeth(const std::vector<Points>& segments, const std::vector<Points>& shapes, int steps);

/// How the curvature becomes the length of a tooth: `scale` times the curvature, in units^2, but no more than
/// `longest`.
struct CombScale {
    double scale = 0;
    double longest = 0;
};

/// The automatic scale, times a factor: the largest curvature gives a fifth of the diagonal of the curve's box. But
/// towards a cusp it grows beyond all bounds, and the rest of the comb would vanish: more than ten times the median
/// counts as that much, unless its radius is above a twentieth of the diagonal. Zero where the curve is straight.
/// Linear.
[[nodiscard]] CombScale combScale(const CombTeeth& teeth, const Box& box, double factor);

/// Where a tooth ends.
[[nodiscard]] Point endOf(const CombTooth& tooth, const CombScale& scale);

/// The comb of a chain on one side: it stands outside of every bend and changes sides at inflections. The teeth, and
/// for each segment a line along their ends, interrupted where the speed is zero. Empty where the curve is straight.
/// With many segments the teeth of each are fewer: some thousands in all, but at least three a segment.
[[nodiscard]] Layer curvatureCombLayer(const std::vector<Points>& segments, const std::vector<Points>& shapes,
                                       double factor);

} // namespace kriva
