#pragma once

#include "core/geometry/point.h"

#include <array>
#include <vector>

namespace kriva {

/// The arc of an ellipse as SVG tells it, between two points that come with it.
struct EllipticalArc {
    double radiusX = 0;
    double radiusY = 0;
    double rotation = 0; ///< of the ellipse's own axes, in degrees, in the sense from x to y
    bool isLarge = false;
    bool isPositive = false; ///< in the sense from x to y
};

/// How far the cubics of an arc may be from it, by its larger radius.
inline constexpr double kArcTolerance = 1e-6;

/// Whether a radius is 0, or as good as 0 beside the other one.
[[nodiscard]] bool isLine(const EllipticalArc& arc);

/// Cubics within kArcTolerance of the arc, joined end to end with its tangents; the ends are met bit for bit. Radii
/// that are too small are enlarged; nothing where the ends are one place or isLine().
/// Source: SVG 1.1, appendix F.6; the cubics, Goldapp, Approximation of circular arcs by cubic polynomials,
/// CAGD 8 (1991).
[[nodiscard]] std::vector<std::array<Point, 4>> cubicsOf(const EllipticalArc& arc, Point from, Point to);

} // namespace kriva
