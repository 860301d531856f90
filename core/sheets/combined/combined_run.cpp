#include "core/sheets/combined/combined_run.h"

#include "core/polynomial/bases.h"
#include "core/polynomial/graph.h"
#include "core/polynomial/least_squares.h"

#include <algorithm>

namespace kriva {
namespace {

using Basis = CombinedCurve::Basis;
using Method = CombinedCurve::Method;

std::vector<double> placesOf(std::span<const Point> points) {
    std::vector<double> places;
    places.reserve(points.size());
    for (const Point p : points)
        places.push_back(p.x);
    return places;
}

std::vector<double> nodesOf(const CombinedCurve& curve, std::span<const Point> points, int degree) {
    const std::vector<double> places = placesOf(points);
    const auto [low, high] = std::minmax(points.front().x, points.back().x);
    switch (curve.basis) {
    case Basis::newton:
        return {places.begin(), places.begin() + degree + 1};
    case Basis::lagrange:
        return curve.method == Method::interpolation || degree == 0 ? places : chebyshevPoints(degree, low, high);
    case Basis::power:
    case Basis::chebyshev:
        break;
    }
    return {};
}

std::vector<double> coefficientsOf(Basis basis, const Polynomial& polynomial, std::span<const Point> points,
                                   std::span<const double> nodes) {
    switch (basis) {
    case Basis::power:
        return powerCoefficients(polynomial);
    case Basis::newton:
        return newtonCoefficients(polynomial, nodes);
    case Basis::lagrange:
        return lagrangeCoefficients(polynomial, nodes);
    case Basis::chebyshev:
        break;
    }
    const auto [low, high] = std::minmax(points.front().x, points.back().x);
    return chebyshevCoefficients(polynomial, low, high);
}

/// A run of one point: a polynomial of degree 0, no slope, no piece.
CombinedRun singlePoint(const CombinedCurve& curve, const MonotoneRun& points) {
    const std::span<const Point> only = pointsOf(points, curve.points);
    CombinedRun run;
    run.points = points;
    run.nodes = nodesOf(curve, only, 0);
    run.coefficients = {only.front().y};
    run.start = run.end = {only.front().x, only.front().y, {}};
    return run;
}

/// Each point of the run with the slope of the polynomial at its x.
std::vector<CurveEnd> endsOfPairs(const Polynomial& polynomial, std::span<const Point> points, int direction) {
    const std::vector<DoubleDouble> slopes = slopesAt(polynomial, placesOf(points));
    std::vector<CurveEnd> ends;
    ends.reserve(points.size());
    for (const Point p : points)
        ends.push_back({p.x, p.y, tangentOf(slopes[ends.size()], direction)});
    return ends;
}

} // namespace

CombinedRun fitRun(const CombinedCurve& curve, const MonotoneRun& points) {
    if (points.direction == 0)
        return singlePoint(curve, points);
    const std::span<const Point> own = pointsOf(points, curve.points);
    const Fit fit = curve.method == Method::interpolation ? fitThroughAll(own) : fitLeastSquares(own, curve.degree);
    Graph graph = graphOf(fit.polynomial, own.front().x, own.back().x);
    CombinedRun run;
    run.points = points;
    run.degree = fit.polynomial.degree();
    run.nodes = nodesOf(curve, own, run.degree);
    run.coefficients = coefficientsOf(curve.basis, fit.polynomial, own, run.nodes);
    run.rms = fit.rms;
    run.maxError = fit.maxError;
    run.start = {own.front().x, graph.startValue, tangentOf(graph.startSlope, points.direction)};
    run.end = {own.back().x, graph.endValue, tangentOf(graph.endSlope, points.direction)};
    run.startSlope = graph.startSlope.high;
    run.endSlope = graph.endSlope.high;
    run.slopeVariation = graph.slopeVariation;
    run.graph = std::move(graph.curve);
    run.parts = std::move(graph.parts);
    run.shapes = std::move(graph.shapes);
    if (curve.method == Method::pairs) {
        run.pairEnds = endsOfPairs(fit.polynomial, own, points.direction);
        run.start.y = own.front().y;
        run.end.y = own.back().y;
    }
    return run;
}

} // namespace kriva
