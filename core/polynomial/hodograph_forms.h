#pragma once

#include "core/geometry/point.h"
#include "core/polynomial/double_double.h"

/// Polynomials made of a curve's derivative c(t), in double-double arithmetic: what curvature is made of.
namespace kriva {

/// The components of c, or of a part of it, by their Bernstein coefficients; at least one.
struct ExactHodograph {
    std::vector<DoubleDouble> x;
    std::vector<DoubleDouble> y;
};

/// The derivative of a curve of degree 1 or more, as exact as its control points, divided by `unit`.
[[nodiscard]] ExactHodograph exactHodograph(std::span<const Point> curve, double unit);

/// A power of two, not above the largest component of the control polygon's sides, that keeps products within the
/// range of doubles; 1 where all control points coincide.
[[nodiscard]] double unitOf(std::span<const Point> curve);

/// c x c', whose sign is that of the curvature: the degree is twice that of c less 2; a single 0 where c is constant.
[[nodiscard]] std::vector<DoubleDouble> turning(const ExactHodograph& hodograph);

/// |c|^2.
[[nodiscard]] std::vector<DoubleDouble> speedSquared(const ExactHodograph& hodograph);

} // namespace kriva
