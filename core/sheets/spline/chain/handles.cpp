#include "core/sheets/spline/chain/handles.h"

#include "core/sheets/spline/chain/smooth_chain.h"

#include <algorithm>
#include <cmath>

namespace kriva {
namespace {

using Handles = std::vector<SegmentHandles>;

std::optional<Vector> storedOut(const SplineKnot& knot) {
    if (isAutomatic(knot))
        return std::nullopt;
    return knot.out.value_or(knot.at) - knot.at;
}

std::optional<Vector> storedIn(const SplineKnot& knot) {
    if (isAutomatic(knot))
        return std::nullopt;
    return knot.in.value_or(knot.at) - knot.at;
}

Handles mirrorHandles(const SplineCurve& curve, std::span<const Vector> chords) {
    Handles handles(chords.size());
    Vector out = chords[0] / 3;
    for (std::size_t i = 0; i < chords.size(); ++i) {
        handles[i].out = storedOut(curve.knots[i]).value_or(out);
        // (K_next + P1) / 2, seen from K_next: the second derivative vanishes at the segment's far end.
        const Vector in = (handles[i].out - chords[i]) / 2;
        handles[i].in = storedIn(knotAfter(curve, i)).value_or(in);
        out = -handles[i].in;
    }
    if (curve.closed && isAutomatic(curve.knots[0]))
        handles.back().in = -handles[0].out;
    return handles;
}

/// A chord as the centripetal spline sees it.
struct CentripetalStep {
    Vector direction; ///< of length 1; zero where the knots coincide
    double step = 0;  ///< of the spline's own parameter: the root of the length
};

CentripetalStep centripetalStep(Vector chord) {
    const double size = length(chord);
    return size == 0 ? CentripetalStep{} : CentripetalStep{chord / size, std::sqrt(size)};
}

/// The tangent of the centripetal spline at a knot, per unit of its own parameter; zero where a neighbour coincides.
/// The chords are unit vectors times squares of the steps, so that its three terms come down to the sum of these unit
/// vectors: nothing is left over where a chain turns straight back.
Vector centripetalTangent(const CentripetalStep& before, const CentripetalStep& after) {
    if (before.step == 0 || after.step == 0)
        return {};
    return (before.direction + after.direction) * (before.step / (before.step + after.step) * after.step);
}

Handles catmullRomHandles(const SplineCurve& curve, std::span<const Vector> chords) {
    Handles handles(chords.size());
    std::vector<CentripetalStep> steps(chords.size());
    std::ranges::transform(chords, steps.begin(), centripetalStep);
    const std::size_t knotCount = curve.knots.size();
    for (std::size_t i = 0; i < knotCount; ++i) {
        // At an open end the missing neighbour is the mirror image of the other one, so its chord is the same.
        const bool isFirst = i == 0 && !curve.closed;
        const bool isLast = i == chords.size();
        const std::size_t arriving = isFirst ? 0 : (i + chords.size() - 1) % chords.size();
        const std::size_t leaving = isLast ? arriving : i;
        const Vector tangent = centripetalTangent(steps[arriving], steps[leaving]);
        if (!isFirst)
            handles[arriving].in = storedIn(curve.knots[i]).value_or(-(tangent * steps[arriving].step) / 3);
        if (!isLast)
            handles[leaving].out = storedOut(curve.knots[i]).value_or(tangent * steps[leaving].step / 3);
    }
    return handles;
}

/// Tangents of one run of segments between two knots where it may break: knots that are not automatic, open ends.
std::vector<Vector> runTangents(const SplineCurve& curve, std::span<const Vector> chords, const SplineKnot& first,
                                const SplineKnot& last) {
    const std::optional<Vector> start = storedOut(first);
    std::optional<Vector> end = storedIn(last);
    if (end)
        end = -*end;
    std::vector<Vector> natural = c2Tangents(chords, start, end);
    if (curve.rule != SplineCurve::Rule::clamped || curve.closed || (start && end))
        return natural;
    // An end with neither a stored handle nor a derivative keeps the natural spline's, whatever the other end has.
    const auto clamped = [](std::optional<Vector> stored, std::optional<Vector> derivative, Vector otherwise) {
        return stored ? *stored : derivative ? *derivative / 3 : otherwise;
    };
    return c2Tangents(chords, clamped(start, curve.startDerivative, natural.front()),
                      clamped(end, curve.endDerivative, natural.back()));
}

/// Knots at which the chain falls apart into runs, ascending.
std::vector<std::size_t> breaksOf(const SplineCurve& curve) {
    std::vector<std::size_t> breaks;
    const std::size_t last = curve.knots.size() - 1;
    for (std::size_t i = 0; i <= last; ++i)
        if (!isAutomatic(curve.knots[i]) || (!curve.closed && (i == 0 || i == last)))
            breaks.push_back(i);
    return breaks;
}

Handles c2Handles(const SplineCurve& curve, std::span<const Vector> chords) {
    Handles handles(chords.size());
    const auto place = [&](std::size_t first, std::span<const Vector> tangents) {
        for (std::size_t k = 0; k + 1 < tangents.size(); ++k)
            handles[(first + k) % chords.size()] = {tangents[k], -tangents[k + 1]};
    };
    std::vector<std::size_t> breaks = breaksOf(curve);
    if (breaks.empty()) {
        place(0, periodicC2Tangents(chords));
        return handles;
    }
    if (curve.closed)
        breaks.push_back(breaks.front() + curve.knots.size());
    for (std::size_t b = 0; b + 1 < breaks.size(); ++b) {
        std::vector<Vector> run(breaks[b + 1] - breaks[b]);
        for (std::size_t k = 0; k < run.size(); ++k)
            run[k] = chords[(breaks[b] + k) % chords.size()];
        const SplineKnot& last = curve.knots[breaks[b + 1] % curve.knots.size()];
        place(breaks[b], runTangents(curve, run, curve.knots[breaks[b]], last));
    }
    return handles;
}

} // namespace

std::vector<Vector> chordsOf(const SplineCurve& curve) {
    std::vector<Vector> chords(segmentCount(curve));
    for (std::size_t i = 0; i < chords.size(); ++i)
        chords[i] = knotAfter(curve, i).at - curve.knots[i].at;
    return chords;
}

std::vector<SegmentHandles> cubicHandles(const SplineCurve& curve, std::span<const Vector> chords) {
    if (chords.empty())
        return {};
    switch (curve.rule) {
    case SplineCurve::Rule::mirror:
        return mirrorHandles(curve, chords);
    case SplineCurve::Rule::catmullRom:
        return catmullRomHandles(curve, chords);
    case SplineCurve::Rule::natural:
    case SplineCurve::Rule::clamped:
        break;
    }
    return c2Handles(curve, chords);
}

} // namespace kriva
