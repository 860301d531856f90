#include "core/sheets/spline/chain/spline_curve.h"

#include "core/bezier/elevate.h"
#include "core/sheets/spline/chain/handles.h"
#include "core/sheets/spline/chain/smooth_chain.h"

#include <algorithm>

namespace kriva {
namespace {

const Points* replacedInner(const SplineCurve& curve, std::size_t segment) {
    if (innerCount(curve.degree) == 0)
        return nullptr;
    const auto found = curve.inner.find(static_cast<int>(segment));
    return found == curve.inner.end() ? nullptr : &found->second;
}

/// The segments before their degree is raised, seen from their first knots, one after the other in the same place:
/// visit(Points& polygon, std::size_t segment).
template <class Visit>
void forEachPlainPolygon(const SplineCurve& curve, Visit visit) {
    if (isIncomplete(curve))
        return;
    const Point origin;
    const std::vector<Vector> chords = chordsOf(curve);
    const bool isQuadratic = curve.degree == 2;
    const std::vector<Vector> middles = isQuadratic ? quadraticMiddles(chords) : std::vector<Vector>();
    const std::vector<SegmentHandles> handles =
        isQuadratic ? std::vector<SegmentHandles>() : cubicHandles(curve, chords);
    Points polygon;
    for (std::size_t i = 0; i < chords.size(); ++i) {
        const Vector chord = chords[i];
        if (isQuadratic)
            polygon.assign({origin, origin + middles[i], origin + chord});
        else
            polygon.assign({origin, origin + handles[i].out, origin + (chord + handles[i].in), origin + chord});
        visit(polygon, i);
    }
}

/// Raises a segment to the curve's degree and puts in what replaces its inner points.
void raise(Points& polygon, const SplineCurve& curve, std::size_t segment) {
    if (curve.degree > 3)
        polygon = elevated(polygon, curve.degree - 3);
    if (const Points* inner = replacedInner(curve, segment))
        std::ranges::transform(*inner, polygon.begin() + kFirstInner,
                               [&](Point p) { return Point{} + (p - curve.knots[segment].at); });
}

/// The segments seen from their first knots; none while the curve is incomplete.
std::vector<Points> localPolygons(const SplineCurve& curve) {
    std::vector<Points> polygons;
    polygons.reserve(segmentCount(curve));
    forEachPlainPolygon(curve, [&](Points& polygon, std::size_t segment) {
        raise(polygon, curve, segment);
        polygons.push_back(polygon);
    });
    return polygons;
}

std::vector<Continuity> continuityOf(const std::vector<Points>& segments, std::size_t knotCount) {
    std::vector<Continuity> continuity(knotCount, Continuity::end);
    for (std::size_t i = 1; i < segments.size(); ++i)
        continuity[i] = continuityBetween(segments[i - 1], segments[i]);
    if (segments.size() == knotCount)
        continuity[0] = continuityBetween(segments.back(), segments.front());
    return continuity;
}

/// Moves a polygon from the origin to its knot; what the curve itself holds is taken over without a rounding.
void moveToKnots(Points& polygon, const SplineCurve& curve, std::size_t segment) {
    const SplineKnot& from = curve.knots[segment];
    const SplineKnot& to = knotAfter(curve, segment);
    // Each point from the nearer knot: a handle that is retracted onto its knot stands on it bit for bit.
    const Point start = polygon.front();
    const Point end = polygon.back();
    for (std::size_t i = 0; i < polygon.size(); ++i)
        polygon[i] = 2 * i < polygon.size() ? from.at + (polygon[i] - start) : to.at + (polygon[i] - end);
    if (const Points* inner = replacedInner(curve, segment))
        std::ranges::copy(*inner, polygon.begin() + kFirstInner);
    if (curve.degree != 3)
        return;
    if (!isAutomatic(from) && from.out)
        polygon[1] = *from.out;
    if (!isAutomatic(to) && to.in)
        polygon[2] = *to.in;
}

} // namespace

const SplineKnot& knotAfter(const SplineCurve& curve, std::size_t segment) {
    return curve.knots[(segment + 1) % curve.knots.size()];
}

bool isIncomplete(const SplineCurve& curve) {
    return curve.knots.size() < (curve.closed ? 3u : 2u);
}

std::size_t segmentCount(const SplineCurve& curve) {
    if (isIncomplete(curve))
        return 0;
    return curve.closed ? curve.knots.size() : curve.knots.size() - 1;
}

bool hasSegmentBefore(const SplineCurve& curve, std::size_t knot) {
    return !isIncomplete(curve) && (curve.closed || knot > 0);
}

bool hasSegmentAfter(const SplineCurve& curve, std::size_t knot) {
    return knot < segmentCount(curve);
}

std::size_t innerCount(int degree) {
    return degree > 3 ? static_cast<std::size_t>(degree - 3) : 0;
}

SplineChain solveSpline(const SplineCurve& curve) {
    SplineChain chain{localPolygons(curve), {}};
    // Told before the polygons move: far from the origin the roundings of absolute positions would break C2.
    if (!isIncomplete(curve))
        chain.continuity = continuityOf(chain.segments, curve.knots.size());
    for (std::size_t i = 0; i < chain.segments.size(); ++i)
        moveToKnots(chain.segments[i], curve, i);
    return chain;
}

std::vector<Points> segmentsOf(const SplineCurve& curve) {
    std::vector<Points> segments = localPolygons(curve);
    for (std::size_t i = 0; i < segments.size(); ++i)
        moveToKnots(segments[i], curve, i);
    return segments;
}

Path pathOf(const SplineCurve& curve) {
    const std::size_t count = segmentCount(curve);
    Path path{{}, std::vector<int>(count, curve.degree), curve.closed};
    path.points.reserve(count * static_cast<std::size_t>(curve.degree) + 1);
    forEachPlainPolygon(curve, [&](Points& polygon, std::size_t segment) {
        raise(polygon, curve, segment);
        moveToKnots(polygon, curve, segment);
        path.points.insert(path.points.end(), polygon.begin() + (segment == 0 ? 0 : 1), polygon.end());
    });
    return path;
}

std::vector<Points> shapesOf(const SplineCurve& curve) {
    std::vector<Points> shapes;
    shapes.reserve(segmentCount(curve));
    forEachPlainPolygon(curve, [&](Points& polygon, std::size_t i) {
        const SplineKnot& from = curve.knots[i];
        const SplineKnot& to = knotAfter(curve, i);
        if (replacedInner(curve, i))
            raise(polygon, curve, i);
        else if (curve.degree > 2 && !isAutomatic(from) && !isAutomatic(to))
            polygon.assign({from.at, from.out.value_or(from.at), to.in.value_or(to.at), to.at});
        shapes.push_back(polygon);
    });
    return shapes;
}

} // namespace kriva
