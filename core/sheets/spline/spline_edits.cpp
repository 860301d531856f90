#include "core/curve/limits.h"
#include "core/sheets/spline/editing/joins.h"
#include "core/sheets/spline/spline.h"

#include <algorithm>

namespace kriva {
namespace {

using Join = SplineKnot::Join;

int countOf(const SplineCurve& curve) {
    return static_cast<int>(curve.knots.size());
}

/// The inner points where an index map takes their segments. A segment goes on where its two knots stay neighbours; in
/// the other order it is run through backwards, and its points are too.
std::map<int, Points> followed(const SplineCurve& old, const IndexMap& map, int newCount) {
    const auto goesOn = [&](int from, int to) {
        return to == from + 1 || (old.closed && from == newCount - 1 && to == 0);
    };
    std::map<int, Points> inner;
    for (const auto& [segment, points] : old.inner) {
        if (static_cast<std::size_t>(segment) >= segmentCount(old))
            continue;
        const int from = map(segment);
        const int to = map((segment + 1) % countOf(old));
        if (from == IndexMap::kGone || to == IndexMap::kGone)
            continue;
        if (goesOn(from, to))
            inner.emplace(from, points);
        else if (goesOn(to, from))
            inner.emplace(to, Points(points.rbegin(), points.rend()));
    }
    return inner;
}

/// Stores every handle that the mirror rule placed: at automatic knots it mirrors them.
SplineCurve withMirrorFrozen(const SplineCurve& curve) {
    if (curve.rule != SplineCurve::Rule::mirror)
        return curve;
    std::vector<int> automatic;
    for (int i = 0; i < countOf(curve); ++i)
        if (isAutomatic(curve.knots[static_cast<std::size_t>(i)]))
            automatic.push_back(i);
    return withJoin(curve, automatic, Join::symmetric);
}

/// The map of a closed chain that keeps its first knot when it is turned round.
IndexMap mapTurned(int count) {
    IndexMap map;
    for (int old = 0; old < count; ++old)
        map.newIndex.push_back(old == 0 ? 0 : count - old);
    return map;
}

} // namespace

bool isWithin(const SplineCurve& curve, double limit) {
    const auto isFine = [limit](std::optional<Point> p) { return !p || isWithin(*p, limit); };
    const auto isFineTip = [&](std::optional<Vector> v) { return !v || isWithin(Point{} + *v, limit); };
    return std::ranges::all_of(curve.knots,
                               [&](const SplineKnot& knot) {
                                   return isWithin(knot.at, limit) && isFine(knot.in) && isFine(knot.out);
                               }) &&
           std::ranges::all_of(curve.inner, [&](const auto& inner) { return areWithin(inner.second, limit); }) &&
           isFineTip(curve.startDerivative) && isFineTip(curve.endDerivative);
}

std::optional<FileError> pointLimitError(const SplineCurve& curve) {
    return pointCountError(curve.knots.size(), limits::kPointsInCurve);
}

Edited<SplineCurve> withPointAdded(SplineCurve curve, Point at) {
    return {withPointsAdded(std::move(curve), std::span(&at, 1)), {}};
}

SplineCurve withPointsAdded(SplineCurve curve, std::span<const Point> points) {
    SplineCurve added;
    for (const Point at : points)
        added.knots.push_back({at, Join::automatic, {}, {}});
    return appended(std::move(curve), added);
}

SplineCurve appended(SplineCurve curve, const SplineCurve& other) {
    if (other.knots.empty())
        return curve;
    const int count = countOf(curve);
    if (curve.closed) // the closing segment goes, and another comes
        curve.inner.erase(count - 1);
    if (curve.degree == other.degree)
        for (const auto& [segment, points] : other.inner)
            if (segment + 1 < countOf(other))
                curve.inner.emplace(count + segment, points);
    curve.knots.insert(curve.knots.end(), other.knots.begin(), other.knots.end());
    return repaired(std::move(curve));
}

Edited<SplineCurve> withPointsRemoved(const SplineCurve& curve, const std::vector<int>& indices) {
    Edited<SplineCurve> edited{curve, mapWithout(countOf(curve), indices)};
    edited.curve.knots = without(curve.knots, indices);
    edited.curve.inner = followed(curve, edited.map, countOf(edited.curve));
    edited.curve = repaired(std::move(edited.curve));
    return edited;
}

Edited<SplineCurve> reversed(const SplineCurve& curve) {
    const int count = countOf(curve);
    Edited<SplineCurve> edited{withMirrorFrozen(curve), curve.closed ? mapTurned(count) : mapReversed(count)};
    std::ranges::reverse(edited.curve.knots);
    if (curve.closed && count > 0)
        std::ranges::rotate(edited.curve.knots, edited.curve.knots.end() - 1);
    for (SplineKnot& knot : edited.curve.knots)
        std::swap(knot.in, knot.out);
    const auto negated = [](std::optional<Vector> v) { return v ? std::optional(-*v) : std::nullopt; };
    edited.curve.startDerivative = negated(curve.endDerivative);
    edited.curve.endDerivative = negated(curve.startDerivative);
    edited.curve.inner = followed(curve, edited.map, count);
    return edited;
}

} // namespace kriva
