#include "core/spline/spline_report.h"

#include "core/bezier/bounds.h"
#include "core/bezier/measures/arc_length.h"
#include "core/bezier/measures/bending_energy.h"
#include "core/bezier/measures/curvature_extrema.h"
#include "core/figure/labels.h"
#include "core/geometry/compensated_sum.h"

namespace kriva {
namespace {

struct Measures {
    SplineChain chain;
    std::vector<double> lengths; ///< of the segments
    double length = 0;
    Box bounds;
    int curvatureExtrema = 0;
    std::optional<double> bendingEnergy; ///< nothing where it diverges
};

/// Whether the curvature turns from rising to falling or back where two segments meet with one curvature.
bool isExtremum(Continuity continuity, std::span<const Point> arriving, std::span<const Point> leaving) {
    if (continuity != Continuity::c2 && continuity != Continuity::g2)
        return false;
    const double before = curvatureSlope(arriving, 1).value_or(0);
    const double after = curvatureSlope(leaving, 0).value_or(0);
    return (before < 0 && after > 0) || (before > 0 && after < 0);
}

int countExtrema(const std::vector<Points>& shapes, const std::vector<Continuity>& continuity) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        count += curvatureExtrema(shapes[i]).size();
        const Points& arriving = shapes[(i + shapes.size() - 1) % shapes.size()];
        count += isExtremum(continuity[i], arriving, shapes[i]) ? 1 : 0;
    }
    return static_cast<int>(count);
}

std::optional<double> addBendingEnergies(const std::vector<Points>& shapes) {
    CompensatedSum sum;
    for (const Points& shape : shapes) {
        const std::optional<double> energy = bendingEnergy(shape);
        if (!energy)
            return {};
        sum.add(*energy);
    }
    return sum.value();
}

Measures measure(const SplineCurve& curve) {
    Measures measures;
    measures.chain = solveSpline(curve);
    for (const Points& segment : measures.chain.segments)
        measures.bounds = united(measures.bounds, tightBounds(segment));
    const std::vector<Points> shapes = shapesOf(curve);
    CompensatedSum length;
    for (const Points& shape : shapes) {
        measures.lengths.push_back(arcLength(shape));
        length.add(measures.lengths.back());
    }
    measures.length = length.value();
    measures.curvatureExtrema = countExtrema(shapes, measures.chain.continuity);
    measures.bendingEnergy = addBendingEnergies(shapes);
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
    json.endList()
        .member("curvatureExtrema", measures.curvatureExtrema)
        .member("bendingEnergy", measures.bendingEnergy);
}

std::vector<Result> results(const SplineCurve& curve) {
    const Measures measures = measure(curve);
    std::vector<Result> rows{{Caption::degree, "", curve.degree},
                             {Caption::length, "", measures.length},
                             {Caption::bounds, "", measures.bounds},
                             {Caption::curvatureExtrema, "", measures.curvatureExtrema},
                             {Caption::bendingEnergy, "", measures.bendingEnergy}};
    for (std::size_t i = 0; i < measures.lengths.size(); ++i) {
        const std::string index = decimal(static_cast<int>(i));
        rows.push_back({Caption::segmentLength, index, measures.lengths[i]});
        rows.push_back({Caption::coefficients, index, powerCoefficients(measures.chain.segments[i])});
    }
    for (std::size_t i = 0; i < measures.chain.continuity.size(); ++i) {
        const Continuity continuity = measures.chain.continuity[i];
        const Result::Value value =
            continuity == Continuity::end ? Result::Value(Caption::openEnd) : std::string(nameOf(continuity));
        rows.push_back({Caption::continuity, decimal(static_cast<int>(i)), value});
    }
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
