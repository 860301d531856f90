#include "core/sheets/combined/path_measures.h"

#include "core/bezier/bounds.h"
#include "core/bezier/measures/arc_length.h"
#include "core/bezier/measures/bending_energy.h"
#include "core/bezier/measures/curvature.h"
#include "core/geometry/compensated_sum.h"

#include <algorithm>
#include <limits>

namespace kriva {
namespace {

/// The curves to measure a piece by: itself, or the parts that tell it better.
std::span<const Points> measuredCurves(const Combined& combined, const PathPiece& piece) {
    if (piece.kind == PathPiece::Kind::run)
        return combined.runs[static_cast<std::size_t>(piece.index)].parts;
    return {&piece.curve.points, 1};
}

/// The same curves by their shapes, which tell length and bending more exactly.
std::span<const Points> measuredShapes(const Combined& combined, const PathPiece& piece) {
    if (piece.kind == PathPiece::Kind::run)
        return combined.runs[static_cast<std::size_t>(piece.index)].shapes;
    return {&piece.curve.shape, 1};
}

bool isWithinDoubles(const Combined& combined) {
    return std::ranges::all_of(combined.path, [&](const PathPiece& piece) {
        return std::ranges::all_of(measuredCurves(combined, piece),
                                   [](const Points& curve) { return std::isfinite(polygonLength(curve)); });
    });
}

/// Straightness and standstill are those of the piece as a whole, even where it is measured in parts.
std::optional<double> energyOf(const PathPiece& piece, std::span<const Points> shapes) {
    constexpr double kStandstill = 1e-9; // of the polygon's length, as in bendingEnergy()
    const Points& whole = piece.curve.points;
    if (shapes.size() == 1)
        return bendingEnergy(shapes.front());
    if (isStraight(whole))
        return 0;
    // A graph of so high a degree that it is cut turns between its ends; there its speed is the width of its x.
    if (std::abs(whole.back().x - whole.front().x) < kStandstill * polygonLength(whole))
        return {};
    double sum = 0;
    for (const Points& shape : shapes) {
        const std::optional<double> energy = bendingEnergy(shape);
        if (!energy)
            return {};
        sum += *energy;
    }
    return sum;
}

double angleBetween(Vector a, Vector b) {
    return std::atan2(std::abs(cross(a, b)), dot(a, b));
}

double largestKink(std::span<const PathPiece> path) {
    double largest = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
        largest = std::max(largest, angleBetween(path[i - 1].curve.endTangent, path[i].curve.startTangent));
    return largest;
}

} // namespace

std::optional<PathMeasures> measure(const Combined& combined, std::span<const Point> points, WorkBudget& budget) {
    PathMeasures measures;
    for (const CombinedRun& run : combined.runs)
        measures.slopeVariation += run.slopeVariation;
    measures.largestKink = largestKink(combined.path);
    if (!isWithinDoubles(combined)) {
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        measures.length = kInfinity;
        measures.bounds = {-kInfinity, -kInfinity, kInfinity, kInfinity};
        return measures;
    }
    CompensatedSum length;
    CompensatedSum bending;
    bool diverges = false;
    for (const PathPiece& piece : combined.path) {
        if (!budget.spend())
            return {};
        const std::span<const Points> shapes = measuredShapes(combined, piece);
        for (const Points& shape : shapes)
            length.add(arcLength(shape));
        for (const Points& curve : measuredCurves(combined, piece))
            measures.bounds = united(measures.bounds, tightBounds(curve));
        const std::optional<double> energy = energyOf(piece, shapes);
        bending.add(energy.value_or(0));
        diverges = diverges || !energy;
    }
    measures.length = length.value();
    if (!diverges)
        measures.bendingEnergy = bending.value();
    if (combined.path.empty())
        measures.bounds = boxOf(points);
    return measures;
}

PathMeasures measure(const Combined& combined, std::span<const Point> points) {
    return withoutLimit([&](WorkBudget& budget) { return measure(combined, points, budget); });
}

} // namespace kriva
