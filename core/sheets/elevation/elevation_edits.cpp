#include "core/bezier/elevate.h"
#include "core/bezier/nearest.h"
#include "core/bezier/pull.h"
#include "core/bezier/reduce.h"
#include "core/curve/limits.h"
#include "core/sheets/elevation/elevation.h"

#include <algorithm>
#include <cassert>

namespace kriva {

std::optional<FileError> pointLimitError(const ElevationCurve& curve) {
    return pointCountError(curve.points.size(), limits::kControlPoints);
}

ElevationCurve withGripsMoved(const ElevationCurve& curve, std::span<const GripId> ids, Vector by) {
    ElevationCurve moved = curve;
    moved.points = withPointsMoved(curve.points, ids, by);
    return moved;
}

Edited<ElevationCurve> withPointAdded(ElevationCurve curve, Point at) {
    Edited<ElevationCurve> edited{std::move(curve), {}};
    edited.curve.points.push_back(at);
    return edited;
}

ElevationCurve withPointsAdded(ElevationCurve curve, std::span<const Point> points) {
    curve.points.insert(curve.points.end(), points.begin(), points.end());
    return curve;
}

ElevationCurve appended(ElevationCurve curve, const ElevationCurve& other) {
    return withPointsAdded(std::move(curve), other.points);
}

Edited<ElevationCurve> withPointsRemoved(const ElevationCurve& curve, const std::vector<int>& indices) {
    Edited<ElevationCurve> edited{curve, mapWithout(static_cast<int>(curve.points.size()), indices)};
    edited.curve.points = without(curve.points, indices);
    return edited;
}

Edited<ElevationCurve> reversed(const ElevationCurve& curve) {
    Edited<ElevationCurve> edited{curve, mapReversed(static_cast<int>(curve.points.size()))};
    std::reverse(edited.curve.points.begin(), edited.curve.points.end());
    return edited;
}

std::optional<Edited<ElevationCurve>> withPointInserted(const ElevationCurve& curve, Point) {
    if (isIncomplete(curve) || curve.points.size() == limits::kControlPoints)
        return {};
    Edited<ElevationCurve> edited{curve, mapOfEnds(static_cast<int>(curve.points.size()), 1)};
    edited.curve.points = elevated(curve.points, 1);
    return edited;
}

bool canTakeElevatedPolygon(const ElevationCurve& curve) {
    return !isIncomplete(curve) && curve.times > 0 && derivedPointCount(curve) <= limits::kControlPoints;
}

ElevationCurve withElevatedPolygon(const ElevationCurve& curve) {
    assert(canTakeElevatedPolygon(curve));
    ElevationCurve taken = curve;
    taken.points = elevated(curve.points, curve.times);
    taken.times = 0;
    return taken;
}

std::optional<Refitted<ElevationCurve>> withDegreeReduced(const ElevationCurve& curve) {
    std::optional<Reduction> reduction = isIncomplete(curve) ? std::nullopt : reduced(curve.points);
    if (!reduction)
        return {};
    Refitted<ElevationCurve> refitted{{curve, mapOfEnds(static_cast<int>(curve.points.size()), -1)},
                                      reduction->maxDeviation};
    refitted.edited.curve.points = std::move(reduction->points);
    return refitted;
}

std::optional<ElevationCurve> withCurvePulled(const ElevationCurve& curve, Point from, Vector by) {
    if (isIncomplete(curve))
        return {};
    std::optional<Points> points = pulled(curve.points, nearest(curve.points, from).t, by);
    if (!points)
        return {};
    ElevationCurve moved = curve;
    moved.points = std::move(*points);
    return moved;
}

std::optional<Frame<ElevationCurve>> atFrame(const ElevationCurve& curve, const FramePlace& place) {
    const bool isTimes = place.over == FramePlace::Over::stage && place.at >= 0 && place.at <= limits::kElevations;
    if (!isTimes)
        return {};
    ElevationCurve raised = curve;
    raised.times = static_cast<int>(place.at);
    return Frame<ElevationCurve>{std::move(raised)};
}

} // namespace kriva
