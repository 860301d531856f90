#include "ui/canvas/base/hit_test.h"

#include "core/geometry/segment.h"
#include "ui/canvas/base/qt_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace kriva::ui {
namespace {

// Grips whose distances differ by less than this are in one place for the eye and the hand.
constexpr double kSamePlace = 0.5;

/// In pixels; infinite where it is beyond the reach, which is told without a root.
[[nodiscard]] double distanceWithin(double reach, QPointF pixel, Point p, const Viewport& viewport) {
    const QPointF way = viewport.toPixels(p) - pixel;
    if (std::abs(way.x()) > reach || std::abs(way.y()) > reach)
        return std::numeric_limits<double>::infinity();
    return std::hypot(way.x(), way.y());
}

[[nodiscard]] double nearestDistance(QPointF pixel, std::span<const HitTarget> targets, const Viewport& viewport) {
    double nearest = kGripReach;
    for (const HitTarget& target : targets)
        for (const Grip& grip : target.grips)
            nearest = std::min(nearest, distanceWithin(kGripReach, pixel, grip.at, viewport));
    return nearest;
}

[[nodiscard]] std::optional<GripRef> gripAt(QPointF pixel, std::span<const HitTarget> targets, const Viewport& viewport,
                                            const Selection& selection) {
    using Preference = std::tuple<bool, bool, bool, double>; // the largest wins
    const double reach = std::min(kGripReach, nearestDistance(pixel, targets, viewport) + kSamePlace);
    std::optional<GripRef> best;
    Preference bestPreference;
    for (const HitTarget& target : targets) {
        for (const Grip& grip : target.grips) {
            const double away = distanceWithin(kGripReach, pixel, grip.at, viewport);
            if (away > reach)
                continue;
            const GripRef candidate{target.serial, grip.id};
            const Preference preference{selection.contains(candidate), grip.id.kind == GripKind::point, target.isActive,
                                        -away};
            if (!best || preference > bestPreference) {
                best = candidate;
                bestPreference = preference;
            }
        }
    }
    return best;
}

[[nodiscard]] double distanceToLines(QPointF pixel, std::span<const QPolygonF> polylines) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const QPolygonF& polyline : polylines)
        for (qsizetype i = 1; i < polyline.size(); ++i)
            nearest = std::min(nearest, distanceToSegment(toCore(pixel), toCore(polyline[i - 1]), toCore(polyline[i])));
    return nearest;
}

[[nodiscard]] std::optional<Serial> curveAt(QPointF pixel, std::span<const HitTarget> targets) {
    std::optional<Serial> best;
    double nearest = kCurveReach;
    bool isBestActive = false;
    for (const HitTarget& target : targets) {
        const double away = distanceToLines(pixel, target.lines);
        if (away > nearest || (away == nearest && best && isBestActive))
            continue;
        best = target.serial;
        nearest = away;
        isBestActive = target.isActive;
    }
    return best;
}

[[nodiscard]] std::optional<MarkPlace> markAt(QPointF pixel, std::span<const HitTarget> targets,
                                              const Viewport& viewport) {
    std::optional<MarkPlace> best;
    double nearest = kCurveReach;
    for (const HitTarget& target : targets) {
        for (const Layer& layer : target.layers) {
            for (const Marks& marks : layer.marks) {
                for (const Point at : marks.at) {
                    const double away = distanceWithin(kCurveReach, pixel, at, viewport);
                    if (away > nearest)
                        continue;
                    best = {marks.role, at};
                    nearest = away;
                }
            }
        }
    }
    return best;
}

} // namespace

Hit hitAt(QPointF pixel, std::span<const HitTarget> targets, const Viewport& viewport, const Selection& selection) {
    if (const auto grip = gripAt(pixel, targets, viewport, selection))
        return {grip, std::nullopt};
    return {std::nullopt, curveAt(pixel, targets), markAt(pixel, targets, viewport)};
}

Selection pointsIn(const QRectF& rectangle, std::span<const HitTarget> targets, const Viewport& viewport) {
    Selection inside;
    for (const HitTarget& target : targets)
        for (const Grip& grip : target.grips)
            if (grip.id.kind == GripKind::point && rectangle.contains(viewport.toPixels(grip.at)))
                inside.insert({target.serial, grip.id});
    return inside;
}

} // namespace kriva::ui
