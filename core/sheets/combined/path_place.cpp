#include "core/sheets/combined/path_place.h"

#include "core/bezier/evaluate.h"

#include <limits>

namespace kriva {
namespace {

/// The last point of a run, but for its end, that does not lie beyond x.
int lastPointUpTo(double x, const MonotoneRun& run, std::span<const Point> points) {
    int index = run.first;
    while (index + 1 < run.last && run.direction * points[static_cast<std::size_t>(index) + 1].x <= run.direction * x)
        ++index;
    return index;
}

/// The middle of a piece between two neighbouring points, if it runs between them.
std::optional<Point> middleOf(const PathPiece& piece, const Combined& combined, std::span<const Point> points,
                              int index) {
    const Points& polygon = piece.curve.points;
    if (piece.kind == PathPiece::Kind::run) {
        const MonotoneRun& run = combined.runs[static_cast<std::size_t>(piece.index)].points;
        if (index < run.first || index >= run.last)
            return {};
        const double x =
            midpoint(points[static_cast<std::size_t>(index)], points[static_cast<std::size_t>(index) + 1]).x;
        const double from = polygon.front().x; // x is linear in the parameter
        return evaluate(polygon, (x - from) / (polygon.back().x - from));
    }
    const int first =
        piece.kind == PathPiece::Kind::pair
            ? piece.index
            : combined.runs[static_cast<std::size_t>(combined.joins[static_cast<std::size_t>(piece.index)].afterRun)]
                  .points.last;
    return first == index ? std::optional(evaluate(polygon, 0.5)) : std::nullopt;
}

} // namespace

std::optional<PathPlace> placeNear(const Combined& combined, Point point) {
    PathPlace place;
    place.nearest.distance = std::numeric_limits<double>::infinity();
    for (const PathPiece& piece : combined.path) {
        if (leastDistance(piece.curve.points, point) >= place.nearest.distance)
            continue;
        const NearestPoint found = nearest(piece.curve.points, point);
        if (found.distance < place.nearest.distance)
            place = {&piece, found};
    }
    return place.piece ? std::optional(place) : std::nullopt;
}

int pointBefore(const Combined& combined, std::span<const Point> points, const PathPlace& place) {
    const auto index = static_cast<std::size_t>(place.piece->index);
    switch (place.piece->kind) {
    case PathPiece::Kind::run:
        return lastPointUpTo(place.nearest.at.x, combined.runs[index].points, points);
    case PathPiece::Kind::join:
        return combined.runs[static_cast<std::size_t>(combined.joins[index].afterRun)].points.last;
    case PathPiece::Kind::pair:
        break;
    }
    return place.piece->index;
}

Point placeBehind(const Combined& combined, std::span<const Point> points, int index) {
    for (const PathPiece& piece : combined.path)
        if (const std::optional<Point> middle = middleOf(piece, combined, points, index))
            return *middle;
    return midpoint(points[static_cast<std::size_t>(index)], points[static_cast<std::size_t>(index) + 1]);
}

} // namespace kriva
