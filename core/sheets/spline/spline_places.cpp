#include "core/bezier/measures/arc_length.h"
#include "core/bezier/nearest.h"
#include "core/sheets/spline/editing/chain_edits.h"
#include "core/sheets/spline/spline.h"

#include <algorithm>
#include <limits>

namespace kriva {
namespace {

/// A place of a chain, not too near to a knot: what pulls or cuts there would have to act on nothing.
struct ChainPlace {
    int segment = 0;
    double t = 0;
};
constexpr double kLeastT = 1e-3;

std::optional<ChainPlace> placeNear(const SplineCurve& curve, Point point) {
    const std::vector<Points> segments = segmentsOf(curve);
    std::optional<ChainPlace> place;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (leastDistance(segments[i], point) >= least)
            continue;
        const NearestPoint found = nearest(segments[i], point);
        if (found.distance >= least)
            continue;
        least = found.distance;
        place = ChainPlace{static_cast<int>(i), std::clamp(found.t, kLeastT, 1 - kLeastT)};
    }
    return place;
}

int longestSegment(const SplineCurve& curve) {
    std::vector<double> lengths;
    for (const Points& shape : shapesOf(curve))
        lengths.push_back(arcLength(shape));
    return static_cast<int>(std::ranges::max_element(lengths) - lengths.begin());
}

} // namespace

std::optional<Edited<SplineCurve>> withPointInserted(const SplineCurve& curve, Point near) {
    const std::optional<ChainPlace> place = placeNear(curve, near);
    if (!place)
        return {};
    return withKnotInserted(curve, place->segment, place->t);
}

std::optional<Edited<SplineCurve>> withPointInsertedBehind(const SplineCurve& curve, std::optional<int> knot) {
    const int count = static_cast<int>(segmentCount(curve));
    if (count == 0)
        return {};
    return withKnotInserted(curve, knot ? std::min(*knot, count - 1) : longestSegment(curve), 0.5);
}

std::optional<SplineCurve> withCurvePulled(const SplineCurve& curve, Point from, Vector by) {
    const std::optional<ChainPlace> place = placeNear(curve, from);
    if (!place || curve.degree == 2)
        return {};
    return withSegmentPulled(curve, place->segment, place->t, by);
}

} // namespace kriva
