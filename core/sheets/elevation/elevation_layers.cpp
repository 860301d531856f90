#include "core/sheets/elevation/elevation_layers.h"

#include "core/bezier/elevate.h"
#include "core/geometry/hull.h"

#include <algorithm>

namespace kriva {
namespace {

/// Each step from polygon to polygon rounds once more: after so many the next one is raised from the control points.
constexpr int kMostStepsInARow = 16;

constexpr double kFaintest = 0.3; // the first ones stand alone, far from the others
constexpr double kStrongest = 0.75;
/// Thin, or a hundred of them are a blot.
constexpr double kThin = 0.4;

/// How far a tangent goes beyond the leg it continues, by the leg and at least by the polygon: legs shrink with every
/// elevation. How long the head of its arrow is at most, by the arrow and by the polygon.
constexpr double kBeyond = 0.3;
constexpr double kBeyondOfPolygon = 0.1;
constexpr double kHeadOfArrow = 0.3;
constexpr double kHeadOfPolygon = 0.035;
constexpr double kHeadHalfWidth = 0.35; // by its length

/// Along the leg and beyond it.
void addTangent(Layer& layer, Point from, Point legEnd, double size) {
    const Vector leg = legEnd - from;
    const Vector along = leg / length(leg);
    const Point to = legEnd + std::max(kBeyond * length(leg), kBeyondOfPolygon * size) * along;
    const Vector back = -std::min(kHeadOfPolygon * size, kHeadOfArrow * length(to - from)) * along;
    const Vector aside = kHeadHalfWidth * Vector{-back.y, back.x};
    layer.strokes.push_back({polyline(Points{from, to}), Role::tangent});
    layer.strokes.push_back({polyline(Points{to + back + aside, to, to + back - aside}), Role::tangent});
}

} // namespace

std::vector<int> shownElevations(int times) {
    const int between = std::max(0, times - 1);
    const int room = std::max(1, kMostPolygonPoints / std::max(1, times / 2));
    const int count = std::min({between, kMostPolygons - 2, room});
    std::vector<int> shown;
    for (int i = 1; i <= count; ++i) // whole numbers all the way: 10'000 elevations times 100 polygons fit
        shown.push_back(count == between ? i : i * times / (count + 1));
    return shown;
}

Layer allPolygonsLayer(const ElevationCurve& curve) {
    Layer layer{"all-polygons"};
    const std::vector<int> shown = shownElevations(curve.times);
    CurveStyle thin;
    thin.width = kThin;
    thin.dash = LineDash::solid;
    Points polygon = curve.points;
    int raised = 0;
    int stepsInARow = 0;
    for (const int times : shown) {
        const bool isNear = times - raised < static_cast<int>(curve.points.size());
        stepsInARow = isNear && stepsInARow < kMostStepsInARow ? stepsInARow + 1 : 0;
        polygon = stepsInARow > 0 ? elevated(polygon, times - raised) : elevated(curve.points, times);
        raised = times;
        const double way = static_cast<double>(layer.strokes.size() + 1) / static_cast<double>(shown.size());
        const double strength = kFaintest + (kStrongest - kFaintest) * way;
        layer.strokes.push_back({polyline(polygon), Role::derivedPolygon, 0, strength, thin});
    }
    return layer;
}

Layer convexHullLayer(std::span<const Point> polygon) {
    Points corners = convexHull(polygon);
    const bool isArea = corners.size() > 2;
    if (isArea)
        corners.push_back(corners.front());
    Path path = polyline(corners);
    path.isClosed = isArea;
    return {"convex-hull", {{std::move(path), Role::hull}}};
}

Layer endTangentsLayer(std::span<const Point> polygon) {
    Layer layer{"end-tangents"};
    const auto second = std::ranges::find_if(polygon, [&](Point p) { return p != polygon.front(); });
    if (second == polygon.end())
        return layer;
    const auto secondLast =
        std::find_if(polygon.rbegin(), polygon.rend(), [&](Point p) { return p != polygon.back(); });
    const double size = diagonal(boxOf(polygon));
    addTangent(layer, polygon.front(), *second, size);
    if (secondLast != polygon.rend())
        addTangent(layer, *secondLast, polygon.back(), size);
    return layer;
}

} // namespace kriva
