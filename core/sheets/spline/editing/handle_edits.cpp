#include "core/sheets/spline/editing/handle_edits.h"

#include "core/sheets/spline/editing/joins.h"

#include <algorithm>

namespace kriva {
namespace {

using Join = SplineKnot::Join;

/// The curve with the knots edited one by one, each given its handles as they stand.
template <class Edit>
SplineCurve edited(const SplineCurve& curve, std::span<const int> knots, const Edit& edit) {
    if (curve.degree == 2)
        return curve;
    const std::vector<KnotHandles> handles = knotHandles(curve);
    SplineCurve changed = withDerivativesHeld(curve, handles);
    for (const int index : knots)
        edit(changed.knots[static_cast<std::size_t>(index)], handles[static_cast<std::size_t>(index)]);
    return changed.knots == curve.knots ? curve : changed;
}

std::vector<int> ofJoin(const SplineCurve& curve, std::span<const int> knots, bool (*hasJoin)(Join)) {
    std::vector<int> found;
    std::ranges::copy_if(knots, std::back_inserter(found),
                         [&](int knot) { return hasJoin(curve.knots[static_cast<std::size_t>(knot)].join); });
    return found;
}

/// A vector as long as asked for in the direction of another one, which is not zero.
Vector along(Vector direction, double size) {
    return size / length(direction) * direction;
}

void equalize(SplineKnot& knot, const KnotHandles& handles) {
    if (!handles.in || !handles.out)
        return;
    const Vector in = *handles.in - knot.at;
    const Vector out = *handles.out - knot.at;
    const double mean = (length(in) + length(out)) / 2;
    if (length(in) == length(out))
        return;
    knot.in = knot.at + along(in == Vector{} ? -out : in, mean);
    knot.out = knot.at + along(out == Vector{} ? -in : out, mean);
}

/// The handles of a symmetric knot: half of what the rule places between them.
void pullEvenly(SplineKnot& knot, const KnotHandles& placed) {
    const Point in = placed.in ? *placed.in : mirrored(*placed.out, knot.at);
    const Point out = placed.out ? *placed.out : mirrored(*placed.in, knot.at);
    const Vector half = (out - in) / 2;
    knot.in = knot.at - half;
    knot.out = knot.at + half;
}

/// `placed` says where the rule would place the handles.
void pullOut(SplineKnot& knot, const KnotHandles& placed) {
    const bool isInside = placed.in && knot.in == knot.at;
    const bool isOutside = placed.out && knot.out == knot.at;
    if (isInside)
        knot.in = placed.in;
    if (isOutside)
        knot.out = placed.out;
    if (knot.join == Join::symmetric && (isInside || isOutside))
        pullEvenly(knot, placed);
    const bool isTied = knot.join == Join::smooth && knot.in && knot.out;
    if (isTied && isInside && !isOutside && *knot.out != knot.at)
        knot.in = knot.at - along(*knot.out - knot.at, distance(*knot.in, knot.at));
    else if (isTied && isOutside && !isInside && *knot.in != knot.at)
        knot.out = knot.at - along(*knot.in - knot.at, distance(*knot.out, knot.at));
}

} // namespace

SplineCurve withHandlesAligned(const SplineCurve& curve, std::span<const int> knots) {
    const std::vector<int> corners = ofJoin(curve, knots, [](Join join) { return join == Join::corner; });
    if (corners.empty() || curve.degree == 2)
        return curve;
    SplineCurve aligned = withJoin(curve, corners, Join::smooth);
    for (const int knot : corners)
        aligned.knots[static_cast<std::size_t>(knot)].join = Join::corner;
    return aligned;
}

SplineCurve withHandlesEqualized(const SplineCurve& curve, std::span<const int> knots) {
    if (curve.degree == 2)
        return curve;
    const std::vector<int> automatic = ofJoin(curve, knots, [](Join join) { return join == Join::automatic; });
    const std::vector<int> free =
        ofJoin(curve, knots, [](Join join) { return join == Join::smooth || join == Join::corner; });
    const SplineCurve tied = automatic.empty() ? curve : withJoin(curve, automatic, Join::symmetric);
    return edited(tied, free, equalize);
}

SplineCurve withHandlesPulledOut(const SplineCurve& curve, std::span<const int> knots) {
    const std::vector<int> stored = ofJoin(curve, knots, [](Join join) { return join != Join::automatic; });
    if (stored.empty() || curve.degree == 2)
        return curve;
    SplineCurve asPlaced = curve;
    for (const int knot : stored)
        asPlaced.knots[static_cast<std::size_t>(knot)].join = Join::automatic;
    const std::vector<KnotHandles> placed = knotHandles(asPlaced);
    SplineCurve pulled = curve;
    for (const int knot : stored)
        pullOut(pulled.knots[static_cast<std::size_t>(knot)], placed[static_cast<std::size_t>(knot)]);
    return pulled;
}

SplineCurve withHandlesRetracted(const SplineCurve& curve, std::span<const int> knots) {
    return edited(curve, knots, [](SplineKnot& knot, const KnotHandles& handles) {
        if (!handles.in && !handles.out)
            return;
        knot.join = Join::corner;
        if (handles.in)
            knot.in = knot.at;
        if (handles.out)
            knot.out = knot.at;
    });
}

} // namespace kriva
