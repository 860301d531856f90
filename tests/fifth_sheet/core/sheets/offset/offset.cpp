#include "core/sheets/offset/offset.h"

#include "core/curve/limits.h"
#include "core/geometry/segment.h"

#include <algorithm>
#include <utility>

namespace kriva {
namespace {

/// To the left of an edge, of length 1; nothing where it is no edge.
std::optional<Vector> normalOf(Point from, Point to) {
    const Vector way = to - from;
    const double size = length(way);
    return size > 0 ? std::optional(Vector{-way.y / size, way.x / size}) : std::nullopt;
}

/// Where the edge starts that is nearest to a point; the curve has one.
std::size_t nearestEdge(const OffsetCurve& curve, Point near) {
    std::size_t best = 0;
    for (std::size_t i = 1; i + 1 < curve.points.size(); ++i)
        if (distanceToSegment(near, curve.points[i], curve.points[i + 1]) <
            distanceToSegment(near, curve.points[best], curve.points[best + 1]))
            best = i;
    return best;
}

Edited<OffsetCurve> split(const OffsetCurve& curve, std::size_t edge) {
    const int at = static_cast<int>(edge) + 1;
    Edited<OffsetCurve> edited{curve, mapWithInserted(static_cast<int>(curve.points.size()), at)};
    edited.curve.points.insert(edited.curve.points.begin() + at, midpoint(curve.points[edge], curve.points[edge + 1]));
    return edited;
}

} // namespace

Points offsetPolygon(std::span<const Point> points, double distance) {
    Points moved;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto before = i > 0 ? normalOf(points[i - 1], points[i]) : std::nullopt;
        const auto behind = i + 1 < points.size() ? normalOf(points[i], points[i + 1]) : std::nullopt;
        const Vector first = before.value_or(behind.value_or(Vector{}));
        const Vector second = behind.value_or(first);
        const double sharp = std::max(1 + dot(first, second), 2 / (kSharpest * kSharpest));
        moved.push_back(points[i] + distance / sharp * (first + second));
    }
    return moved;
}

std::vector<Points> offsetPolygons(const OffsetCurve& curve) {
    std::vector<Points> polygons;
    for (int i = 1; i <= curve.times; ++i)
        polygons.push_back(offsetPolygon(curve.points, i * curve.distance));
    return polygons;
}

std::optional<FileError> pointLimitError(const OffsetCurve& curve) {
    return pointCountError(curve.points.size(), limits::kPointsInCurve);
}

OffsetCurve withGripsMoved(const OffsetCurve& curve, std::span<const GripId> ids, Vector by) {
    OffsetCurve moved = curve;
    moved.points = withPointsMoved(curve.points, ids, by);
    return moved;
}

Edited<OffsetCurve> withPointAdded(OffsetCurve curve, Point at) {
    return {withPointsAdded(std::move(curve), std::span(&at, 1)), {}};
}

OffsetCurve withPointsAdded(OffsetCurve curve, std::span<const Point> points) {
    curve.points.insert(curve.points.end(), points.begin(), points.end());
    return curve;
}

OffsetCurve appended(OffsetCurve curve, const OffsetCurve& other) {
    return withPointsAdded(std::move(curve), other.points);
}

std::optional<Edited<OffsetCurve>> withPointInserted(const OffsetCurve& curve, Point near) {
    return isIncomplete(curve) ? std::nullopt : std::optional(split(curve, nearestEdge(curve, near)));
}

std::optional<Edited<OffsetCurve>> withPointInsertedBehind(const OffsetCurve& curve, std::optional<int> index) {
    if (isIncomplete(curve))
        return {};
    const std::size_t last = curve.points.size() - 2;
    return split(curve, index ? std::min(static_cast<std::size_t>(*index), last) : last);
}

std::optional<OffsetCurve> withCurvePulled(const OffsetCurve& curve, Point from, Vector by) {
    if (isIncomplete(curve))
        return {};
    const std::size_t edge = nearestEdge(curve, from);
    OffsetCurve pulled = curve;
    for (const std::size_t end : {edge, edge + 1})
        pulled.points[end] = curve.points[end] + by;
    return pulled;
}

Edited<OffsetCurve> withPointsRemoved(const OffsetCurve& curve, const std::vector<int>& indices) {
    Edited<OffsetCurve> edited{curve, mapWithout(static_cast<int>(curve.points.size()), indices)};
    edited.curve.points = without(curve.points, indices);
    return edited;
}

Edited<OffsetCurve> reversed(const OffsetCurve& curve) {
    Edited<OffsetCurve> edited{curve, mapReversed(static_cast<int>(curve.points.size()))};
    std::ranges::reverse(edited.curve.points);
    edited.curve.distance = -curve.distance; // what was to the left is to the right now
    return edited;
}

std::optional<Frame<OffsetCurve>> atFrame(const OffsetCurve& curve, const FramePlace& place) {
    if (place.over != FramePlace::Over::stage || place.at < 0 || place.at > limits::kOffsets)
        return {};
    Frame<OffsetCurve> frame{curve};
    frame.value.times = static_cast<int>(place.at);
    return frame;
}

} // namespace kriva
