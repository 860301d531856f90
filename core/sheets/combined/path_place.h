#pragma once

#include "core/bezier/nearest.h"
#include "core/sheets/combined/combined.h"

#include <optional>

namespace kriva {

/// Where the path passes nearest to a point.
struct PathPlace {
    const PathPiece* piece = nullptr; ///< of the combined curve that was asked
    NearestPoint nearest;
};

/// Nothing where the path has no piece. Linear in the pieces.
[[nodiscard]] std::optional<PathPlace> placeNear(const Combined& combined, Point point);

/// The index of the given point behind which a place lies, in drawing order.
[[nodiscard]] int pointBefore(const Combined& combined, std::span<const Point> points, const PathPlace& place);

/// The middle of the path between the given points `index` and `index + 1`: by x within a polynomial, by the parameter
/// elsewhere; the middle of the points where there is no path between them.
[[nodiscard]] Point placeBehind(const Combined& combined, std::span<const Point> points, int index);

} // namespace kriva
