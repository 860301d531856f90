#include "core/sheets/spline/editing/joins.h"

#include "core/sheets/spline/chain/handles.h"

namespace kriva {
namespace {

using Join = SplineKnot::Join;

void makeSymmetric(SplineKnot& knot) {
    const Vector half = (*knot.out - *knot.in) / 2;
    knot.in = knot.at - half;
    knot.out = knot.at + half;
}

void makeSmooth(SplineKnot& knot) {
    const Vector across = *knot.out - *knot.in;
    if (across == Vector{})
        return;
    const Vector direction = across / length(across);
    knot.in = knot.at - distance(*knot.in, knot.at) * direction;
    knot.out = knot.at + distance(*knot.out, knot.at) * direction;
}

/// The knot with stored handles; a side that no segment uses has nothing to tie.
SplineKnot joined(SplineKnot knot, Join join, const KnotHandles& handles) {
    knot.join = join;
    knot.in = handles.in;
    knot.out = handles.out;
    if (!knot.in || !knot.out)
        return knot;
    if (join == Join::symmetric)
        makeSymmetric(knot);
    else if (join == Join::smooth)
        makeSmooth(knot);
    return knot;
}

bool lacksHandle(const SplineCurve& curve, std::size_t i) {
    const SplineKnot& knot = curve.knots[i];
    return !isAutomatic(knot) && ((hasSegmentBefore(curve, i) && !knot.in) || (hasSegmentAfter(curve, i) && !knot.out));
}

/// `placed` says where the rule would place the handles of knots that have none at all.
void completeHandles(SplineKnot& knot, const KnotHandles& placed) {
    if (knot.in && !knot.out)
        knot.out = mirrored(*knot.in, knot.at);
    else if (knot.out && !knot.in)
        knot.in = mirrored(*knot.out, knot.at);
    else
        knot = joined(knot, knot.join, placed);
}

void repairHandles(SplineCurve& curve) {
    std::vector<std::size_t> lacking;
    for (std::size_t i = 0; i < curve.knots.size(); ++i)
        if (lacksHandle(curve, i))
            lacking.push_back(i);
    if (lacking.empty() || curve.degree == 2)
        return;
    SplineCurve asPlaced = curve;
    for (const std::size_t i : lacking)
        asPlaced.knots[i].join = Join::automatic;
    const std::vector<KnotHandles> placed = knotHandles(asPlaced);
    for (const std::size_t i : lacking)
        completeHandles(curve.knots[i], placed[i]);
}

} // namespace

std::vector<KnotHandles> knotHandles(const SplineCurve& curve) {
    std::vector<KnotHandles> handles(curve.knots.size());
    if (curve.degree == 2)
        return handles;
    const std::vector<SegmentHandles> bySegment = cubicHandles(curve, chordsOf(curve));
    for (std::size_t i = 0; i < bySegment.size(); ++i) {
        const std::size_t next = (i + 1) % curve.knots.size();
        const SplineKnot& from = curve.knots[i];
        const SplineKnot& to = curve.knots[next];
        handles[i].out = !isAutomatic(from) && from.out ? *from.out : from.at + bySegment[i].out;
        handles[next].in = !isAutomatic(to) && to.in ? *to.in : to.at + bySegment[i].in;
    }
    return handles;
}

EndDerivatives endDerivatives(const SplineCurve& curve, std::span<const KnotHandles> handles) {
    EndDerivatives ends;
    if (curve.rule != SplineCurve::Rule::clamped || curve.closed || curve.degree == 2 || isIncomplete(curve))
        return ends;
    const SplineKnot& first = curve.knots.front();
    const SplineKnot& last = curve.knots.back();
    if (isAutomatic(first))
        ends.start = curve.startDerivative.value_or(3 * (*handles.front().out - first.at));
    if (isAutomatic(last))
        ends.end = curve.endDerivative.value_or(3 * (last.at - *handles.back().in));
    return ends;
}

SplineKnot withHandleAt(SplineKnot knot, HandleSide side, Point to) {
    if (isAutomatic(knot))
        knot.join = Join::symmetric;
    std::optional<Point>& moved = side == HandleSide::in ? knot.in : knot.out;
    std::optional<Point>& other = side == HandleSide::in ? knot.out : knot.in;
    moved = to;
    if (knot.join == Join::symmetric)
        other = mirrored(to, knot.at);
    const Vector onwards = knot.at - to;
    if (knot.join == Join::smooth && other && onwards != Vector{})
        other = knot.at + distance(*other, knot.at) / length(onwards) * onwards;
    return knot;
}

SplineCurve withJoin(const SplineCurve& curve, std::span<const int> knots, Join join) {
    const std::vector<KnotHandles> handles = knotHandles(curve);
    SplineCurve changed = join == Join::automatic ? curve : withDerivativesHeld(curve, handles);
    for (const int index : knots) {
        const auto i = static_cast<std::size_t>(index);
        changed.knots[i] = joined(curve.knots[i], join, join == Join::automatic ? KnotHandles{} : handles[i]);
    }
    return repaired(std::move(changed));
}

SplineKnot loosened(SplineKnot knot, const KnotHandles& handles) {
    if (knot.join != Join::corner)
        knot.join = Join::smooth;
    knot.in = handles.in;
    knot.out = handles.out;
    return knot;
}

SplineCurve withDerivativesHeld(SplineCurve curve, std::span<const KnotHandles> handles) {
    if (curve.startDerivative.has_value() == curve.endDerivative.has_value())
        return curve;
    const EndDerivatives ends = endDerivatives(curve, handles);
    if (!curve.startDerivative)
        curve.startDerivative = ends.start;
    if (!curve.endDerivative)
        curve.endDerivative = ends.end;
    return curve;
}

SplineCurve repaired(SplineCurve curve) {
    repairHandles(curve);
    const std::size_t count = innerCount(curve.degree);
    if (count == 0)
        return curve;
    std::erase_if(curve.inner, [&](const auto& entry) {
        const auto& [segment, points] = entry;
        const bool isBeyond = !isIncomplete(curve) && static_cast<std::size_t>(segment) >= segmentCount(curve);
        return isBeyond || points.size() != count;
    });
    return curve;
}

} // namespace kriva
