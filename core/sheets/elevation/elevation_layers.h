#pragma once

#include "core/figure/figure.h"
#include "core/sheets/elevation/elevation.h"

/// The layers of an elevation that are made only where they are shown.
namespace kriva {

/// How many polygons are drawn at once, the control polygon and the elevated one among them.
inline constexpr int kMostPolygons = 100;
/// How many points they have in all: beyond a thousand elevations nobody can tell neighbours apart.
inline constexpr int kMostPolygonPoints = 50'000;

/// Which elevations stand between none and `times`, ascending: all, or where they are more than a figure draws, as many
/// at even distances, but at least one.
[[nodiscard]] std::vector<int> shownElevations(int times);

/// The polygons after the elevations so far, the latest the strongest. Raised from one to the next, and from the
/// control points wherever that is as quick or rounding would add up: each a few ulp of the polygon's size from exact.
/// O(N) for each of the polygons while their degrees N are neighbours, else O(n N).
[[nodiscard]] Layer allPolygonsLayer(const ElevationCurve& curve);

/// The convex hull of the polygon on view as a closed line; a line or a place where the polygon is one.
[[nodiscard]] Layer convexHullLayer(std::span<const Point> polygon);

/// The tangents at both ends, along b_0 b_1 and b_(n-1) b_n (the first legs with a length) and a little beyond, each
/// with the head of an arrow. Nothing where all points are one.
[[nodiscard]] Layer endTangentsLayer(std::span<const Point> polygon);

} // namespace kriva
