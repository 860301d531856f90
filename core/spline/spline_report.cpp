#include "core/spline/spline_report.h"

#include "core/bezier/arc_length.h"
#include "core/bezier/bounds.h"
#include "core/figure/labels.h"
#include "core/geometry/compensated_sum.h"

namespace kriva {
namespace {

struct Measures {
    SplineChain chain;
    std::vector<double> lengths; ///< of the segments
    double length = 0;
    Box bounds;
};

Measures measure(const SplineCurve& curve) {
    Measures measures{solveSpline(curve), {}, 0, {}};
    CompensatedSum length;
    for (const Points& segment : measures.chain.segments) {
        measures.lengths.push_back(arcLength(segment));
        length.add(measures.lengths.back());
        measures.bounds = united(measures.bounds, tightBounds(segment));
    }
    measures.length = length.value();
    return measures;
}

} // namespace

void reportCurve(JsonWriter& json, const SplineCurve& curve) {
    const Measures measures = measure(curve);
    json.member("degree", curve.degree).member("length", measures.length).member("bounds", measures.bounds);
    json.key("segments").beginList();
    for (std::size_t i = 0; i < measures.lengths.size(); ++i)
        json.beginObject()
            .member("points", measures.chain.segments[i])
            .member("length", measures.lengths[i])
            .endObject();
    json.endList().key("knots").beginList();
    for (const Continuity continuity : measures.chain.continuity)
        json.beginObject().member("continuity", nameOf(continuity)).endObject();
    json.endList();
}

std::vector<Result> results(const SplineCurve& curve) {
    const Measures measures = measure(curve);
    std::vector<Result> rows{{Caption::degree, "", curve.degree},
                             {Caption::length, "", measures.length},
                             {Caption::bounds, "", measures.bounds}};
    for (std::size_t i = 0; i < measures.lengths.size(); ++i) {
        const std::string index = decimal(static_cast<int>(i));
        rows.push_back({Caption::segmentLength, index, measures.lengths[i]});
        rows.push_back({Caption::coefficients, index, powerCoefficients(measures.chain.segments[i])});
    }
    for (std::size_t i = 0; i < measures.chain.continuity.size(); ++i)
        rows.push_back(
            {Caption::continuity, decimal(static_cast<int>(i)), std::string(nameOf(measures.chain.continuity[i]))});
    return rows;
}

Points powerCoefficients(std::span<const Point> segment) {
    Points coefficients{segment.front()};
    std::vector<Vector> differences;
    for (const Point p : segment)
        differences.push_back(p - segment.front());
    double binomial = 1;
    for (std::size_t k = 1; k < segment.size(); ++k) {
        const std::size_t left = segment.size() - k;
        for (std::size_t i = 0; i < left; ++i)
            differences[i] = differences[i + 1] - differences[i];
        binomial *= static_cast<double>(left) / static_cast<double>(k);
        coefficients.push_back(Point{} + binomial * differences[0]);
    }
    return coefficients;
}

} // namespace kriva
