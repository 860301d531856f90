#include "core/curve/limits.h"
#include "core/sheets/combined/combined.h"
#include "core/sheets/combined/path_place.h"

#include <algorithm>
#include <cassert>

namespace kriva {
namespace {

/// So near to its ends a pair can hardly be pulled: its middle point would have to move too far.
constexpr double kLeastT = 1e-2;

/// The corrections of pairs that are still pairs under a map: both points there, and next to each other.
std::map<int, Point> followed(const std::map<int, Point>& corrections, const IndexMap& map) {
    std::map<int, Point> kept;
    for (const auto& [pair, middle] : corrections) {
        const int first = map(pair);
        const int second = map(pair + 1);
        if (first != IndexMap::kGone && second != IndexMap::kGone && std::abs(first - second) == 1)
            kept.emplace(std::min(first, second), middle);
    }
    return kept;
}

/// Middle points beyond the limit of numbers are no grips: they could not be kept as corrections.
std::vector<Grip> middleGrips(const Combined& combined) {
    std::vector<Grip> grips;
    for (const PairMiddle& middle : pairMiddles(combined))
        if (isWithin(middle.at, limits::kNumber))
            grips.push_back({{GripKind::middle, middle.pair}, middle.at});
    return grips;
}

/// The path if it has middle points, else nothing of it.
Combined solved(const CombinedCurve& curve) {
    const bool hasMiddles = curve.method == CombinedCurve::Method::pairs && !isIncomplete(curve);
    return hasMiddles ? combine(curve) : Combined();
}

/// The point behind which the next one is farthest away.
int longestStep(std::span<const Point> points) {
    int longest = 0;
    double most = -1;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double step = distance(points[i - 1], points[i]);
        if (step > most) {
            most = step;
            longest = static_cast<int>(i) - 1;
        }
    }
    return longest;
}

[[maybe_unused]] bool hasPair(const CombinedCurve& curve, int pair) {
    return pair >= 0 && static_cast<std::size_t>(pair) + 1 < curve.points.size();
}

} // namespace

std::vector<Grip> grips(const CombinedCurve& curve) {
    return grips(curve, solved(curve));
}

std::vector<Grip> grips(const CombinedCurve& curve, const Combined& combined) {
    std::vector<Grip> all = pointGrips(curve.points);
    const std::vector<Grip> middles = middleGrips(combined);
    all.insert(all.end(), middles.begin(), middles.end());
    return all;
}

bool isWithin(const CombinedCurve& curve, double limit) {
    return areWithin(curve.points, limit) && std::ranges::all_of(curve.corrections, [&](const auto& correction) {
               return isWithin(correction.second, limit);
           });
}

std::optional<FileError> pointLimitError(const CombinedCurve& curve) {
    std::size_t longest = 0;
    if (curve.method == CombinedCurve::Method::interpolation)
        for (const MonotoneRun& run : monotoneRuns(curve.points))
            longest = std::max(longest, run.size());
    if (longest > limits::kControlPoints)
        return errorOfFile(FileProblem::tooManyPointsInRun,
                           {static_cast<double>(limits::kControlPoints), static_cast<double>(longest)});
    return pointCountError(curve.points.size(), limits::kPointsInCurve);
}

CombinedCurve withGripsMoved(const CombinedCurve& curve, std::span<const GripId> ids, Vector by) {
    CombinedCurve moved = curve;
    moved.points = withPointsMoved(curve.points, ids, by);
    if (std::ranges::none_of(ids, [](const GripId& id) { return id.kind == GripKind::middle; }))
        return moved;
    std::vector<GripId> sorted(ids.begin(), ids.end()); // there may be as many as points
    std::ranges::sort(sorted);
    for (const Grip& grip : middleGrips(solved(curve)))
        if (std::ranges::binary_search(sorted, grip.id))
            moved.corrections[grip.id.index] = grip.at + by;
    return moved;
}

Edited<CombinedCurve> withPointAdded(CombinedCurve curve, Point at) {
    return {withPointsAdded(std::move(curve), std::span(&at, 1)), {}};
}

CombinedCurve withPointsAdded(CombinedCurve curve, std::span<const Point> points) {
    curve.points.insert(curve.points.end(), points.begin(), points.end());
    // A curve without points may hold corrections of any pair; one that has some holds those of its own pairs.
    if (!isIncomplete(curve))
        std::erase_if(curve.corrections, [&](const auto& entry) {
            return static_cast<std::size_t>(entry.first) + 1 >= curve.points.size();
        });
    return curve;
}

CombinedCurve appended(CombinedCurve curve, const CombinedCurve& other) {
    const int count = static_cast<int>(curve.points.size());
    curve = withPointsAdded(std::move(curve), other.points);
    for (const auto& [pair, middle] : other.corrections)
        if (static_cast<std::size_t>(pair) + 1 < other.points.size())
            curve.corrections.insert_or_assign(count + pair, middle);
    return curve;
}

Edited<CombinedCurve> withPointsRemoved(const CombinedCurve& curve, const std::vector<int>& indices) {
    Edited<CombinedCurve> edited{curve, mapWithout(static_cast<int>(curve.points.size()), indices)};
    edited.curve.points = without(curve.points, indices);
    edited.curve.corrections = followed(curve.corrections, edited.map);
    return edited;
}

Edited<CombinedCurve> reversed(const CombinedCurve& curve) {
    Edited<CombinedCurve> edited{curve, mapReversed(static_cast<int>(curve.points.size()))};
    std::reverse(edited.curve.points.begin(), edited.curve.points.end());
    edited.curve.corrections = followed(curve.corrections, edited.map);
    return edited;
}

Edited<CombinedCurve> withPointInserted(const CombinedCurve& curve, int index, Point at) {
    const int count = static_cast<int>(curve.points.size());
    assert(index >= 0 && index <= count);
    Edited<CombinedCurve> edited{curve, mapWithInserted(count, index)};
    edited.curve.points.insert(edited.curve.points.begin() + index, at);
    edited.curve.corrections = followed(curve.corrections, edited.map);
    return edited;
}

CombinedCurve withCorrection(const CombinedCurve& curve, int pair, std::optional<Point> middle) {
    assert(hasPair(curve, pair));
    CombinedCurve corrected = curve;
    if (middle)
        corrected.corrections[pair] = *middle;
    else
        corrected.corrections.erase(pair);
    return corrected;
}

CombinedCurve withPairThrough(const CombinedCurve& curve, int pair, double t, Point place) {
    assert(hasPair(curve, pair) && t > 0 && t < 1);
    const Point start = curve.points[static_cast<std::size_t>(pair)];
    const Point end = curve.points[static_cast<std::size_t>(pair) + 1];
    const Vector fromStart = (place - start) - t * t * (end - start);
    return withCorrection(curve, pair, start + fromStart / (2 * t * (1 - t)));
}

std::optional<Edited<CombinedCurve>> withPointInserted(const CombinedCurve& curve, Point near) {
    if (curve.points.size() < 2)
        return {};
    const Combined combined = combine(curve);
    const std::optional<PathPlace> place = placeNear(combined, near);
    if (!place) // the points are all in one place
        return withPointInserted(curve, 1, near);
    return withPointInserted(curve, pointBefore(combined, curve.points, *place) + 1, place->nearest.at);
}

std::optional<Edited<CombinedCurve>> withPointInsertedBehind(const CombinedCurve& curve, std::optional<int> point) {
    const int count = static_cast<int>(curve.points.size());
    if (count < 2)
        return {};
    const int index = point ? std::min(*point, count - 2) : longestStep(curve.points);
    return withPointInserted(curve, index + 1, placeBehind(combine(curve), curve.points, index));
}

std::optional<CombinedCurve> withCurvePulled(const CombinedCurve& curve, Point from, Vector by) {
    if (curve.method != CombinedCurve::Method::pairs || isIncomplete(curve))
        return {};
    const Combined combined = combine(curve);
    const std::optional<PathPlace> place = placeNear(combined, from);
    if (!place || place->piece->kind != PathPiece::Kind::pair || place->nearest.t < kLeastT ||
        place->nearest.t > 1 - kLeastT)
        return {};
    return withPairThrough(curve, place->piece->index, place->nearest.t, place->nearest.at + by);
}

std::optional<Frame<CombinedCurve>> atFrame(const CombinedCurve& curve, const FramePlace& place) {
    const bool isStage = place.over == FramePlace::Over::stage && place.at >= 1 && place.at <= kCombinedStages;
    if (!isStage)
        return {};
    const int stage = static_cast<int>(place.at);
    return Frame<CombinedCurve>{curve, stage < kCombinedStages ? std::optional(stage - 1) : std::nullopt};
}

} // namespace kriva
