#pragma once

#include "core/geometry/point.h"

#include <optional>

namespace kriva {

struct Reduction {
    Points points;           ///< control points of the curve of one degree less
    double maxDeviation = 0; ///< largest distance of the two curves at the same parameter
};

/// The curve of one degree less with the same ends whose squared distance from the given one, integrated over the
/// parameter, is least. Exact for curves that have the lower degree. Nothing for degree 0 and 1, whose ends leave no
/// freedom. O(degree^2).
///
/// The difference of the two curves vanishes at the ends and has the given curve's leading coefficient; of all such
/// polynomials t (1 - t) J(t) is the least, J the Jacobi polynomial of weight t^2 (1 - t)^2.
/// Source: Szego, Orthogonal Polynomials, theorem 3.1.2 (least norm) and formula (4.3.2) (Bernstein coefficients).
[[nodiscard]] std::optional<Reduction> reduced(std::span<const Point> curve);

} // namespace kriva
