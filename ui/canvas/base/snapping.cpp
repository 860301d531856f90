#include "ui/canvas/base/snapping.h"

#include "core/bezier/evaluate.h"
#include "core/bezier/nearest.h"
#include "core/curve/limits.h"
#include "core/polynomial/sign_changes.h"
#include "ui/canvas/base/grid.h"

#include <algorithm>

namespace kriva::ui {
namespace {

/// The nearest of the places offered, if one is within reach.
class NearestPlace {
  public:
    NearestPlace(Point from, double reach)
        : from_(from)
        , reach_(reach) {}

    void offer(Point place) {
        const double away = distance(from_, place);
        if (away > reach_ || (best_ && away == reach_))
            return;
        reach_ = away;
        best_ = place;
    }
    /// Whether a piece with these control points might come near enough.
    [[nodiscard]] bool mayReach(std::span<const Point> piece) const {
        return overlap(grown(boxOf(piece), reach_), {from_.x, from_.y, from_.x, from_.y});
    }
    [[nodiscard]] std::optional<Point> best() const { return best_; }

  private:
    Point from_;
    double reach_;
    std::optional<Point> best_;
};

/// The same, as far as the place may go there.
[[nodiscard]] Point alongAxis(const SnappingPlace& place, Point to) {
    return {place.freedom == Freedom::y ? place.at.x : to.x, place.freedom == Freedom::x ? place.at.y : to.y};
}

/// Where a piece meets the axis that the place keeps to.
void offerMeetings(const SnappingPlace& place, std::span<const Point> piece, NearestPlace& nearest) {
    std::vector<double> heights;
    for (const Point p : piece)
        heights.push_back(place.freedom == Freedom::x ? p.y - place.at.y : p.x - place.at.x);
    for (const double t : signChanges(heights))
        nearest.offer(alongAxis(place, evaluate(piece, t)));
}

[[nodiscard]] std::optional<Point> nearestGrip(const SnappingPlace& place, std::span<const SnapTarget> targets,
                                               double reach) {
    NearestPlace nearest(place.at, reach);
    for (const SnapTarget& target : targets)
        for (const Grip& grip : target.grips)
            if (grip.id.kind == GripKind::point &&
                !(target.serial == place.curve && std::ranges::binary_search(place.moving, grip.id)))
                nearest.offer(grip.at);
    const std::optional<Point> best = nearest.best();
    return best ? std::optional(alongAxis(place, *best)) : std::nullopt;
}

[[nodiscard]] std::optional<Point> nearestOnCurves(const SnappingPlace& place, std::span<const SnapTarget> targets,
                                                   double reach) {
    NearestPlace nearest(place.at, reach);
    const auto offer = [&](std::span<const Point> piece) {
        if (!nearest.mayReach(piece))
            return;
        if (place.freedom == Freedom::both)
            nearest.offer(kriva::nearest(piece, place.at).at);
        else
            offerMeetings(place, piece, nearest);
    };
    for (const SnapTarget& target : targets) {
        if (target.serial == place.curve && !place.moving.empty())
            continue;
        for (const Layer& layer : target.figure->layers)
            for (const Stroke& stroke : layer.strokes)
                if (isOfCurve(stroke.role))
                    forEachPiece(stroke.path, offer);
    }
    return nearest.best();
}

[[nodiscard]] Point nearestOfGrid(const SnappingPlace& place, double step) {
    const auto nearest = [step](double number) {
        return std::clamp(nearestMultiple(step, number), -limits::kNumber, limits::kNumber);
    };
    return alongAxis(place, {nearest(place.at.x), nearest(place.at.y)});
}

} // namespace

std::optional<Snap> snapOf(const SnappingPlace& place, std::span<const SnapTarget> targets, const Viewport& viewport,
                           bool hasGrid) {
    const double reach = kSnapReach / viewport.scale;
    if (const auto at = nearestGrip(place, targets, reach))
        return Snap{*at, SnapKind::point};
    if (const auto at = nearestOnCurves(place, targets, reach))
        return Snap{*at, SnapKind::curve};
    if (hasGrid)
        return Snap{nearestOfGrid(place, gridStep(viewport)), SnapKind::grid};
    return {};
}

} // namespace kriva::ui
