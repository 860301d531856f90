#include "core/bezier/evaluate.h"
#include "core/bezier/measures/curvature.h"
#include "core/sheets/spline/editing/joins.h"
#include "core/sheets/spline/spline.h"

#include <algorithm>
#include <limits>

namespace kriva {
namespace {

/// Of each old segment, enough for the two numbers that are fitted; fewer where very many segments go at once.
constexpr std::size_t kSamplesPerSegment = 16;
constexpr std::size_t kSamplesPerGap = 256;
/// An exact fit is found to the last digits within ten steps, the others do not get better.
constexpr int kSteps = 20;
constexpr double kLongest = 3;

/// A place of the old curve and the parameter of the new cubic where it is nearest.
struct Sample {
    Point at;
    double t = 0;
};

/// A cubic with given ends and directions of its handles; their lengths are to be found.
struct Fit {
    Point start;
    Point end;
    Vector startDirection;
    Vector endDirection; ///< from the end into the curve
    double startLength = 0;
    double endLength = 0;
};

Points cubicOf(const Fit& fit) {
    return {fit.start, fit.start + fit.startLength * fit.startDirection, fit.end + fit.endLength * fit.endDirection,
            fit.end};
}

/// Places spread over the old segments, at first with parameters like their way along the curve.
std::vector<Sample> samplesOf(std::span<const Points> segments) {
    const std::size_t count = std::clamp<std::size_t>(kSamplesPerGap / segments.size(), 1, kSamplesPerSegment);
    std::vector<Sample> samples;
    Point last = segments.front().front();
    double way = 0;
    for (const Points& segment : segments)
        for (std::size_t k = 1; k <= count; ++k) {
            const Point at = evaluate(segment, static_cast<double>(k) / static_cast<double>(count));
            way += distance(last, at);
            samples.push_back({at, way});
            last = at;
        }
    for (Sample& sample : samples)
        sample.t = way > 0 ? sample.t / way : 0;
    return samples;
}

/// Moves the parameter towards the foot of the perpendicular (Newton's method, which has a minimum near only where the
/// second derivative of the distance is positive).
double towardsFoot(std::span<const Point> cubic, const Sample& sample) {
    double t = sample.t;
    for (int step = 0; step < 2; ++step) {
        const Vector way = evaluate(cubic, t) - sample.at;
        const Vector first = derivative(cubic, t);
        const double slope = dot(first, first) + dot(way, secondDerivative(cubic, t));
        if (slope > 0)
            t = std::clamp(t - dot(way, first) / slope, 0.0, 1.0);
    }
    return t;
}

/// The normal equations of two unknowns.
struct Normal {
    double a11 = 0;
    double a12 = 0;
    double a22 = 0;
    double b1 = 0;
    double b2 = 0;

    void add(double j1, double j2, double residual) {
        a11 += j1 * j1;
        a12 += j1 * j2;
        a22 += j2 * j2;
        b1 += j1 * residual;
        b2 += j2 * residual;
    }
    /// Zero where the equations do not tell both unknowns apart: below the bound half of the digits are lost.
    [[nodiscard]] Vector solve() const {
        const double determinant = a11 * a22 - a12 * a12;
        if (!(determinant > 1e-12 * a11 * a22))
            return {};
        return {(b1 * a22 - b2 * a12) / determinant, (b2 * a11 - b1 * a12) / determinant};
    }
};

/// One step of Gauss and Newton: the distances along the normals at the feet of the samples are linear in the lengths.
Vector stepOf(const Fit& fit, std::span<const Point> cubic, std::span<const Sample> samples) {
    Normal normal;
    for (const Sample& sample : samples) {
        const Vector tangent = derivative(cubic, sample.t);
        const double speed = length(tangent);
        if (speed == 0)
            continue;
        const Vector across = Vector{-tangent.y, tangent.x} / speed;
        const std::vector<double> weights = bernstein(3, sample.t);
        normal.add(weights[1] * dot(across, fit.startDirection), weights[2] * dot(across, fit.endDirection),
                   dot(across, sample.at - evaluate(cubic, sample.t)));
    }
    return normal.solve();
}

struct Fitted {
    Fit fit;
    double deviation = 0;
};

/// Keeps the best of the steps. A step shortens no handle to less than a tenth, so that none turns round, and lengthens
/// none beyond kLongest times the old way: a cubic that long passes near anything on its way far out and back.
Fitted fitted(std::span<const Points> segments) {
    std::vector<Sample> samples = samplesOf(segments);
    Fit fit{segments.front().front(), segments.back().back(), startTangent(segments.front()).value_or(Vector{}),
            -endTangent(segments.back()).value_or(Vector{})};
    double way = distance(fit.start, samples.front().at);
    for (std::size_t i = 1; i < samples.size(); ++i)
        way += distance(samples[i - 1].at, samples[i].at);
    fit.startLength = fit.endLength = way / 3;
    Fitted best{fit, std::numeric_limits<double>::infinity()};
    for (int step = 0; step < kSteps; ++step) {
        const Points cubic = cubicOf(fit);
        double deviation = 0;
        for (Sample& sample : samples) {
            sample.t = towardsFoot(cubic, sample);
            deviation = std::max(deviation, distance(evaluate(cubic, sample.t), sample.at));
        }
        if (deviation < best.deviation)
            best = {fit, deviation};
        const Vector by = stepOf(fit, cubic, samples);
        fit.startLength = std::clamp(fit.startLength + by.x, fit.startLength / 10, kLongest * way);
        fit.endLength = std::clamp(fit.endLength + by.y, fit.endLength / 10, kLongest * way);
    }
    return best;
}

/// Two knots that stay, and the segments between them, all of whose other knots go.
struct Gap {
    std::size_t from = 0;
    std::size_t to = 0;
    std::vector<Points> segments;
};

/// Gaps at open ends are none: there is nothing to join.
std::vector<Gap> gapsOf(const SplineCurve& curve, const IndexMap& map) {
    const std::vector<Points> segments = segmentsOf(curve);
    const std::size_t count = curve.knots.size();
    const auto stays = [&](std::size_t i) { return map(static_cast<int>(i % count)) != IndexMap::kGone; };
    std::vector<Gap> gaps;
    for (std::size_t from = 0; from < segments.size(); ++from) {
        if (!stays(from) || stays(from + 1))
            continue;
        Gap gap{from, from, {}};
        do {
            gap.segments.push_back(segments[gap.to % segments.size()]);
            ++gap.to;
        } while (!stays(gap.to) && (curve.closed || gap.to < segments.size()));
        gap.to %= count;
        if (stays(gap.to))
            gaps.push_back(std::move(gap));
    }
    return gaps;
}

/// The curve with everything stored that its other segments need to keep their shape.
SplineCurve heldBesides(const SplineCurve& curve, const IndexMap& map) {
    const std::vector<KnotHandles> handles = knotHandles(curve);
    SplineCurve held = withDerivativesHeld(curve, handles);
    const std::size_t count = curve.knots.size();
    for (std::size_t i = 0; i < segmentCount(curve); ++i) {
        const std::size_t next = (i + 1) % count;
        const bool staysFrom = map(static_cast<int>(i)) != IndexMap::kGone;
        const bool staysTo = map(static_cast<int>(next)) != IndexMap::kGone;
        if (staysFrom && !staysTo)
            held.knots[i] = loosened(curve.knots[i], handles[i]);
        if (staysTo && !staysFrom)
            held.knots[next] = loosened(curve.knots[next], handles[next]);
    }
    return held;
}

} // namespace

Refitted<SplineCurve> withPointsRemovedRefitted(const SplineCurve& curve, const std::vector<int>& indices) {
    Refitted<SplineCurve> removal{withPointsRemoved(curve, indices), {}};
    if (curve.degree == 2 || isIncomplete(removal.edited.curve))
        return removal;
    const IndexMap& map = removal.edited.map;
    removal.edited.curve = withPointsRemoved(heldBesides(curve, map), indices).curve;
    for (const Gap& gap : gapsOf(curve, map)) {
        const Fitted best = fitted(gap.segments);
        const Points cubic = cubicOf(best.fit);
        std::vector<SplineKnot>& knots = removal.edited.curve.knots;
        knots[static_cast<std::size_t>(map(static_cast<int>(gap.from)))].out = cubic[1];
        knots[static_cast<std::size_t>(map(static_cast<int>(gap.to)))].in = cubic[2];
        removal.deviation = std::max(removal.deviation.value_or(0), best.deviation);
    }
    return removal;
}

} // namespace kriva
