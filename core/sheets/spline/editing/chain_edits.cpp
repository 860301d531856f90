#include "core/sheets/spline/editing/chain_edits.h"

#include "core/bezier/elevate.h"
#include "core/bezier/evaluate.h"
#include "core/bezier/subdivide.h"
#include "core/sheets/spline/editing/joins.h"

#include <algorithm>
#include <cassert>

namespace kriva {
namespace {

using Join = SplineKnot::Join;

/// Makes room for one more segment behind `segment`.
std::map<int, Points> shiftedBehind(const std::map<int, Points>& inner, int segment) {
    std::map<int, Points> shifted;
    for (const auto& [index, points] : inner)
        shifted.emplace(index > segment ? index + 1 : index, points);
    return shifted;
}

/// The chain cut open at t with everything stored that the two halves need to keep their shape.
SplineCurve cut(const SplineCurve& curve, std::size_t segment, const Halves& halves, double t) {
    const std::vector<KnotHandles> handles = knotHandles(curve);
    const std::size_t next = (segment + 1) % curve.knots.size();
    SplineCurve result = withDerivativesHeld(curve, handles);
    SplineKnot& from = result.knots[segment];
    SplineKnot& to = result.knots[next];
    from = loosened(from, handles[segment]);
    to = loosened(to, handles[next]);
    from.out = lerp(from.at, *from.out, t);
    to.in = lerp(*to.in, to.at, t);

    // The first and last legs of a raised cubic are 3/n of its handles.
    const double legs = curve.degree / 3.0;
    const auto n = static_cast<std::size_t>(curve.degree);
    SplineKnot knot{halves.right.front(), Join::smooth, {}, {}};
    knot.in = knot.at + legs * (halves.left[n - 1] - knot.at);
    knot.out = knot.at + legs * (halves.right[1] - knot.at);

    const bool hasOwnInner = innerCount(curve.degree) > 0 && curve.inner.contains(static_cast<int>(segment));
    result.inner = shiftedBehind(curve.inner, static_cast<int>(segment));
    if (hasOwnInner) {
        result.inner[static_cast<int>(segment)] = innerOf(halves.left);
        result.inner[static_cast<int>(segment) + 1] = innerOf(halves.right);
    }
    result.knots.insert(result.knots.begin() + static_cast<std::ptrdiff_t>(segment) + 1, knot);
    return result;
}

} // namespace

Edited<SplineCurve> withKnotInserted(const SplineCurve& curve, int segment, double t) {
    assert(t > 0 && t < 1);
    const auto index = static_cast<std::size_t>(segment);
    const Points polygon = segmentsOf(curve)[index];
    Edited<SplineCurve> edited{curve, mapWithInserted(static_cast<int>(curve.knots.size()), segment + 1)};
    if (curve.degree > 2) {
        edited.curve = cut(curve, index, split(polygon, t), t);
        return edited;
    }
    edited.curve.knots.insert(edited.curve.knots.begin() + segment + 1,
                              {evaluate(polygon, t), Join::automatic, {}, {}});
    edited.curve.inner = shiftedBehind(curve.inner, segment);
    edited.curve.inner.erase(segment);
    return edited;
}

SplineCurve withDegree(const SplineCurve& curve, int degree) {
    SplineCurve changed = curve;
    changed.degree = degree;
    if (curve.degree == 4 && degree == 5 && !curve.inner.empty()) {
        const SplineChain chain = solveSpline(curve);
        for (auto& [segment, points] : changed.inner)
            if (static_cast<std::size_t>(segment) < chain.segments.size())
                points = innerOf(elevated(chain.segments[static_cast<std::size_t>(segment)], 1));
    }
    return repaired(std::move(changed));
}

SplineCurve withRule(SplineCurve curve, SplineCurve::Rule rule) {
    curve.rule = rule;
    return curve;
}

SplineCurve withClosed(SplineCurve curve, bool closed) {
    curve.closed = closed;
    return repaired(std::move(curve));
}

SplineCurve withEndDerivatives(SplineCurve curve, std::optional<Vector> start, std::optional<Vector> end) {
    curve.startDerivative = start;
    curve.endDerivative = end;
    return curve;
}

SplineCurve withSegmentPulled(const SplineCurve& curve, int segment, double t, Vector by) {
    assert(t > 0 && t < 1);
    if (curve.degree == 2)
        return curve;
    const auto from = static_cast<std::size_t>(segment);
    const std::size_t to = (from + 1) % curve.knots.size();
    // How far the point at t goes with the out and the in handle: 3/n of a leg's Bernstein polynomial, and with inner
    // points that follow the handles, that of the cubic.
    const bool hasOwnInner = innerCount(curve.degree) > 0 && curve.inner.contains(segment);
    const double power = hasOwnInner ? curve.degree - 1 : 2;
    const double outWeight = 3 * t * std::pow(1 - t, power);
    const double inWeight = 3 * (1 - t) * std::pow(t, power);
    const Vector step = by / (outWeight * outWeight + inWeight * inWeight);
    const std::vector<KnotHandles> handles = knotHandles(curve);
    SplineCurve pulled = curve;
    pulled.knots[from] = withHandleAt(curve.knots[from], HandleSide::out, *handles[from].out + outWeight * step);
    pulled.knots[to] = withHandleAt(curve.knots[to], HandleSide::in, *handles[to].in + inWeight * step);
    return pulled;
}

} // namespace kriva
