#pragma once

#include "core/geometry/point.h"

namespace kriva {

/// Rows r = 0..n of de Casteljau's scheme at t; row r holds n + 1 - r points, row 0 the control points.
using Triangle = std::vector<Points>;

[[nodiscard]] Triangle deCasteljau(std::span<const Point> curve, double t);

/// The scheme with another parameter at each level: row r comes from row r - 1 with parameters[r - 1], the last row is
/// the blossom of them all. Needs as many parameters as the degree.
[[nodiscard]] Triangle deCasteljau(std::span<const Point> curve, std::span<const double> parameters);

/// The two parts of a curve cut at t, both running in its direction; they share left.back() == right.front().
struct Halves {
    Points left;
    Points right;
};

/// O(n^2). Source: Farin, Curves and Surfaces for CAGD, 5th ed., section 4.6.
[[nodiscard]] Halves split(std::span<const Point> curve, double t);

/// The same into two arrays as long as the curve; it may be one of them.
void split(std::span<const Point> curve, double t, std::span<Point> left, std::span<Point> right);

/// The part of a curve between two parameters 0 <= from <= to <= 1.
[[nodiscard]] Points part(std::span<const Point> curve, double from, double to);

/// The same into an array as long as the curve, or the curve itself.
void part(std::span<const Point> curve, double from, double to, std::span<Point> result);

/// The 2^levels pieces in curve order when every piece is split at the same local t, `levels` times over.
[[nodiscard]] std::vector<Points> pieces(std::span<const Point> curve, double t, int levels);

/// The same into one array of 2^levels n + 1 points: each piece begins with the last point of the one before.
void writePieces(std::span<const Point> curve, double t, int levels, std::span<Point> chain);

/// The blossom (polar form) b[u_1, .., u_n]: de Casteljau's scheme with another parameter at each level.
/// Symmetric and affine in each argument; b[t, .., t] is the point at t. Needs as many arguments as the degree.
/// Source: Ramshaw, Blossoms are polar forms, CAGD 6 (1989).
[[nodiscard]] Point blossom(std::span<const Point> curve, std::span<const double> arguments);

} // namespace kriva
