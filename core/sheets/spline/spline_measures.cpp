#include "core/sheets/spline/spline_measures.h"

#include "core/bezier/bounds.h"
#include "core/bezier/measures/arc_length.h"
#include "core/bezier/measures/bending_energy.h"
#include "core/bezier/measures/curvature.h"
#include "core/bezier/measures/curvature_extrema.h"
#include "core/geometry/compensated_sum.h"

#include <algorithm>

namespace kriva {
namespace {

/// Whether the curvature turns from rising to falling or back where two segments meet with one curvature.
bool isExtremum(Continuity continuity, std::span<const Point> arriving, std::span<const Point> leaving) {
    if (continuity != Continuity::c2 && continuity != Continuity::g2)
        return false;
    const double before = curvatureSlope(arriving, 1).value_or(0);
    const double after = curvatureSlope(leaving, 0).value_or(0);
    return (before < 0 && after > 0) || (before > 0 && after < 0);
}

int countExtrema(const std::vector<Points>& shapes, const std::vector<Continuity>& continuity, WorkBudget& budget) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < shapes.size() && budget.spend(); ++i) {
        count += curvatureExtrema(shapes[i]).size();
        const Points& arriving = shapes[(i + shapes.size() - 1) % shapes.size()];
        count += isExtremum(continuity[i], arriving, shapes[i]) ? 1 : 0;
    }
    return static_cast<int>(count);
}

std::optional<double> addBendingEnergies(const std::vector<Points>& shapes, WorkBudget& budget) {
    CompensatedSum sum;
    for (const Points& shape : shapes) {
        if (!budget.spend())
            return {};
        const std::optional<double> energy = bendingEnergy(shape);
        if (!energy)
            return {};
        sum.add(*energy);
    }
    return sum.value();
}

} // namespace

std::optional<SplineMeasures> measure(const SplineCurve& curve, WorkBudget& budget) {
    SplineMeasures measures;
    measures.chain = solveSpline(curve);
    for (const Points& segment : measures.chain.segments) {
        if (!budget.spend())
            return {};
        measures.bounds = united(measures.bounds, tightBounds(segment));
    }
    const std::vector<Points> shapes = shapesOf(curve);
    CompensatedSum length;
    for (const Points& shape : shapes) {
        if (!budget.spend())
            return {};
        measures.lengths.push_back(arcLength(shape));
        length.add(measures.lengths.back());
    }
    measures.length = length.value();
    measures.curvatureExtrema = countExtrema(shapes, measures.chain.continuity, budget);
    measures.bendingEnergy = addBendingEnergies(shapes, budget);
    if (budget.end())
        return {};
    return measures;
}

SplineMeasures measure(const SplineCurve& curve) {
    return withoutLimit([&](WorkBudget& budget) { return measure(curve, budget); });
}

std::optional<double> largestCurvature(const SplineCurve& curve, WorkBudget& budget) {
    double largest = 0;
    for (const Points& shape : shapesOf(curve)) {
        if (!budget.spend())
            return {};
        if (isStraight(shape))
            continue;
        std::vector<double> places = curvatureExtrema(shape);
        places.insert(places.end(), {0, 1});
        for (const double t : places) {
            const std::optional<double> there = curvature(shape, t);
            if (!there)
                return {};
            largest = std::max(largest, std::abs(*there));
        }
    }
    return largest;
}

std::vector<Vector> powerCoefficients(std::span<const Point> segment) {
    std::vector<Vector> coefficients{segment.front() - Point{}};
    std::vector<Vector> differences;
    for (const Point p : segment)
        differences.push_back(p - segment.front());
    double binomial = 1;
    for (std::size_t k = 1; k < segment.size(); ++k) {
        const std::size_t left = segment.size() - k;
        for (std::size_t i = 0; i < left; ++i)
            differences[i] = differences[i + 1] - differences[i];
        binomial *= static_cast<double>(left) / static_cast<double>(k);
        coefficients.push_back(binomial * differences[0]);
    }
    return coefficients;
}

} // namespace kriva
