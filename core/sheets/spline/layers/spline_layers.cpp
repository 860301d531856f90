#include "core/sheets/spline/layers/spline_layers.h"

#include "core/bezier/evaluate.h"
#include "core/bezier/measures/curvature.h"
#include "core/bezier/measures/curvature_extrema.h"

#include <algorithm>
#include <array>
#include <limits>

namespace kriva {
namespace {

/// So near to a knot an inflection is that of the knot.
constexpr double kAtKnot = 1e-7;
/// A curvature below this, by the length of the polygon, is none.
constexpr double kStraight = 1e-7;

int signOf(double number) {
    return number > 0 ? 1 : number < 0 ? -1 : 0;
}

/// To which side a segment bends right behind its start, or right before its end: where the curvature is zero there,
/// its slope tells.
int bendAt(std::span<const Point> shape, double t) {
    const double bend = curvature(shape, t).value_or(0);
    if (std::abs(bend) * polygonLength(shape) > kStraight)
        return signOf(bend);
    const double slope = curvatureSlope(shape, t).value_or(0);
    return t == 0 ? signOf(slope) : -signOf(slope);
}

bool isInflection(Continuity continuity, std::span<const Point> arriving, std::span<const Point> leaving) {
    if (continuity == Continuity::c0 || continuity == Continuity::end)
        return false;
    return bendAt(arriving, 1) * bendAt(leaving, 0) < 0;
}

/// The segment where the middles of a chain and of all others are farthest apart.
std::size_t loneliest(std::size_t chain, const std::vector<std::vector<Points>>& chains) {
    std::size_t best = 0;
    double farthest = -1;
    for (std::size_t i = 0; i < chains[chain].size(); ++i) {
        const Point middle = evaluate(chains[chain][i], 0.5);
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t other = 0; other < chains.size(); ++other)
            if (other != chain)
                nearest = std::min(nearest, distance(middle, evaluate(chains[other][i], 0.5)));
        if (nearest > farthest) {
            farthest = nearest;
            best = i;
        }
    }
    return best;
}

} // namespace

Layer inflectionsLayer(const SplineCurve& curve, const SplineChain& chain, const std::vector<Points>& shapes) {
    Points places;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (hasSegmentBefore(curve, i)) {
            const Points& arriving = shapes[(i + shapes.size() - 1) % shapes.size()];
            if (isInflection(chain.continuity[i], arriving, shapes[i]))
                places.push_back(curve.knots[i].at);
        }
        for (const double t : inflections(shapes[i]))
            if (t > kAtKnot && t < 1 - kAtKnot)
                places.push_back(evaluate(chain.segments[i], t));
    }
    return {"inflections", {}, {{std::move(places), Role::inflection}}};
}

Layer continuityLayer(const SplineCurve& curve, const SplineChain& chain) {
    Layer layer{"continuity"};
    for (std::size_t i = 0; i < chain.continuity.size(); ++i) {
        if (chain.continuity[i] == Continuity::end)
            continue;
        Label label{curve.knots[i].at, Caption::none, std::string(nameOf(chain.continuity[i])), "", Role::knot};
        label.side = LabelSide::belowRight; // knots have their names above
        layer.labels.push_back(std::move(label));
    }
    return layer;
}

Layer allRulesLayer(const SplineCurve& curve) {
    constexpr double kFaint = 0.85;
    Layer layer{"all-rules"};
    if (curve.degree == 2)
        return layer;
    std::vector<std::vector<Points>> chains;
    for (const NamedRule& named : kRules) {
        SplineCurve ruled = curve;
        ruled.rule = named.rule;
        chains.push_back(segmentsOf(ruled));
    }
    for (std::size_t i = 0; i < chains.size(); ++i) {
        const int series = static_cast<int>(i);
        layer.strokes.push_back({chain(chains[i], curve.closed), Role::rule, series, kFaint});
        layer.labels.push_back(
            {evaluate(chains[i][loneliest(i, chains)], 0.5), kRules[i].caption, "", "", Role::label});
    }
    return layer;
}

Points deCasteljauPolyline(std::span<const Points> segments, int points) {
    Points polyline;
    polyline.reserve(segments.size() * static_cast<std::size_t>(points - 1) + 1);
    for (const Points& segment : segments)
        for (int i = polyline.empty() ? 0 : 1; i < points; ++i)
            polyline.push_back(evaluate(segment, static_cast<double>(i) / (points - 1)));
    return polyline;
}

Layer polylineLayer(std::span<const Points> segments, int points) {
    Points places = deCasteljauPolyline(segments, points);
    const Path path = polyline(places);
    return {"polyline", {{path, Role::derivedPolygon}}, {{std::move(places), Role::derivedPolygon}}};
}

} // namespace kriva
