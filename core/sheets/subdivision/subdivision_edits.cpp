#include "core/bezier/elevate.h"
#include "core/bezier/nearest.h"
#include "core/bezier/pull.h"
#include "core/curve/limits.h"
#include "core/sheets/subdivision/subdivision.h"

#include <algorithm>
#include <cassert>

namespace kriva {
namespace {

std::size_t degreeOf(const SubdivisionCurve& curve) {
    return std::max<std::size_t>(controlPointCount(curve), 1) - 1;
}

/// To be called after every change of the number of control points.
void fitBlossom(SubdivisionCurve& curve) {
    if (curve.blossom)
        curve.blossom->resize(degreeOf(curve), curve.t);
}

} // namespace

std::size_t derivedPointCount(const SubdivisionCurve& curve) {
    return isIncomplete(curve) ? 0 : controlPointCount(curve) << curve.levels;
}

std::size_t mostPoints(const SubdivisionCurve& curve) {
    const std::size_t repetitions = controlPointCount(curve) - curve.points.size();
    const std::size_t most = mostControlPoints(curve.levels);
    const std::size_t room = most > repetitions ? most - repetitions : 0;
    // What is still being drawn may stand beyond its limits until the next point comes.
    return isIncomplete(curve) ? std::max(room, curve.points.size()) : room;
}

std::optional<FileError> pointLimitError(const SubdivisionCurve& curve) {
    return pointCountError(curve.points.size(), mostPoints(curve));
}

SubdivisionCurve withGripsMoved(const SubdivisionCurve& curve, std::span<const GripId> ids, Vector by) {
    SubdivisionCurve moved = curve;
    moved.points = withPointsMoved(curve.points, ids, by);
    return moved;
}

Edited<SubdivisionCurve> withPointAdded(SubdivisionCurve curve, Point at) {
    return {withPointsAdded(std::move(curve), std::span(&at, 1)), {}};
}

SubdivisionCurve withPointsAdded(SubdivisionCurve curve, std::span<const Point> points) {
    curve.points.insert(curve.points.end(), points.begin(), points.end());
    curve.multiplicity.resize(curve.points.size(), 1);
    fitBlossom(curve);
    return curve;
}

SubdivisionCurve appended(SubdivisionCurve curve, const SubdivisionCurve& other) {
    curve.points.insert(curve.points.end(), other.points.begin(), other.points.end());
    curve.multiplicity.insert(curve.multiplicity.end(), other.multiplicity.begin(), other.multiplicity.end());
    fitBlossom(curve);
    return curve;
}

Edited<SubdivisionCurve> withPointsRemoved(const SubdivisionCurve& curve, const std::vector<int>& indices) {
    Edited<SubdivisionCurve> edited{curve, mapWithout(static_cast<int>(curve.points.size()), indices)};
    edited.curve.points = without(curve.points, indices);
    edited.curve.multiplicity = without(curve.multiplicity, indices);
    fitBlossom(edited.curve);
    return edited;
}

Edited<SubdivisionCurve> reversed(const SubdivisionCurve& curve) {
    Edited<SubdivisionCurve> edited{curve, mapReversed(static_cast<int>(curve.points.size()))};
    SubdivisionCurve& turned = edited.curve;
    std::reverse(turned.points.begin(), turned.points.end());
    std::reverse(turned.multiplicity.begin(), turned.multiplicity.end());
    // A t so small that 1 - t rounds to 1 must stay inside, as an argument must stay within the limit of numbers.
    turned.t = std::min(1 - curve.t, std::nextafter(1.0, 0.0));
    if (turned.blossom)
        for (double& argument : *turned.blossom)
            argument = std::min(1 - argument, limits::kNumber);
    return edited;
}

std::size_t mostControlPoints(int levels) {
    return std::min(limits::kControlPoints, limits::kDerivedPointsInSheet >> levels);
}

int mostLevels(std::size_t controlPoints) {
    int levels = limits::kLevels;
    while (levels > 0 && mostControlPoints(levels) < controlPoints)
        --levels;
    return levels;
}

int mostMultiplicity(const SubdivisionCurve& curve, std::span<const int> indices) {
    assert(!indices.empty());
    auto others = static_cast<int>(controlPointCount(curve));
    for (const int index : indices)
        others -= curve.multiplicity[static_cast<std::size_t>(index)];
    const int room = static_cast<int>(mostControlPoints(curve.levels)) - others;
    return std::max(1, room / static_cast<int>(indices.size()));
}

SubdivisionCurve withMultiplicity(const SubdivisionCurve& curve, int index, int times) {
    assert(times >= 1);
    SubdivisionCurve changed = curve;
    changed.multiplicity[static_cast<std::size_t>(index)] = times;
    fitBlossom(changed);
    return changed;
}

SubdivisionCurve withT(SubdivisionCurve curve, double t) {
    assert(t > 0 && t < 1);
    curve.t = t;
    return curve;
}

SubdivisionCurve withLevels(SubdivisionCurve curve, int levels) {
    assert(levels >= 0 && levels <= mostLevels(controlPointCount(curve)));
    curve.levels = levels;
    return curve;
}

SubdivisionCurve withBlossom(SubdivisionCurve curve, std::optional<std::vector<double>> arguments) {
    assert(!arguments || arguments->size() == degreeOf(curve));
    curve.blossom = std::move(arguments);
    return curve;
}

std::optional<std::array<SubdivisionCurve, 2>> dividedAtCut(const SubdivisionCurve& curve) {
    if (isIncomplete(curve))
        return {};
    Halves halves = split(controlPolygon(curve), curve.t);
    std::array<SubdivisionCurve, 2> parts{curve, curve};
    parts[0].points = std::move(halves.left);
    parts[1].points = std::move(halves.right);
    for (SubdivisionCurve& part : parts) {
        part.multiplicity.assign(part.points.size(), 1);
        part.blossom.reset();
    }
    return parts;
}

std::optional<Edited<SubdivisionCurve>> withPointInserted(const SubdivisionCurve& curve, Point) {
    const int room = mostLevels(controlPointCount(curve) + 1);
    if (isIncomplete(curve) || controlPointCount(curve) == limits::kControlPoints || curve.levels > room)
        return {};
    const int count = static_cast<int>(curve.points.size());
    const int added = static_cast<int>(controlPointCount(curve)) + 1 - count;
    Edited<SubdivisionCurve> edited{curve, mapOfEnds(count, added)};
    edited.curve.points = elevated(controlPolygon(curve), 1);
    edited.curve.multiplicity.assign(edited.curve.points.size(), 1);
    fitBlossom(edited.curve);
    return edited;
}

std::optional<SubdivisionCurve> withCurvePulled(const SubdivisionCurve& curve, Point from, Vector by) {
    if (isIncomplete(curve))
        return {};
    const Points polygon = controlPolygon(curve);
    std::optional<Points> points = pulled(polygon, nearest(polygon, from).t, by);
    if (!points)
        return {};
    SubdivisionCurve moved = curve;
    moved.points = std::move(*points);
    moved.multiplicity.assign(moved.points.size(), 1);
    return moved;
}

std::optional<Frame<SubdivisionCurve>> atFrame(const SubdivisionCurve& curve, const FramePlace& place) {
    if (place.over == FramePlace::Over::t)
        return place.at > 0 && place.at < 1 ? std::optional(Frame<SubdivisionCurve>{withT(curve, place.at)})
                                            : std::nullopt;
    if (!(place.at >= 0 && place.at <= mostLevels(controlPointCount(curve))))
        return {};
    return Frame<SubdivisionCurve>{withLevels(curve, static_cast<int>(place.at))};
}

} // namespace kriva
