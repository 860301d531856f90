#include "core/bezier/elevate.h"
#include "core/figure/labels.h"
#include "core/sheets/elevation/elevation.h"
#include "core/sheets/elevation/elevation_layers.h"

namespace kriva {
namespace {

constexpr std::array kLayers{
    LayerInfo{"convex-hull", translatable("Caption", "Convex hull"), false, true},
    LayerInfo{"all-polygons", translatable("Caption", "All polygons so far"), false, true},
    LayerInfo{"control-polygon", Caption::controlPolygon},
    LayerInfo{"elevated-polygon", translatable("Caption", "Elevated polygon"), true, true},
    LayerInfo{"end-tangents", translatable("Caption", "End tangents"), false, true},
    LayerInfo{kCurveLayer, Caption::curve},
    LayerInfo{"points", Caption::points},
    LayerInfo{"labels", Caption::labels, true, true},
};

} // namespace

std::span<const LayerInfo> layersOf(const ElevationCurve&) {
    return kLayers;
}

Figure figureOf(const ElevationCurve& curve, const FigureContext& context) {
    const auto isWanted = [&](std::string_view layer) {
        return !isIncomplete(curve) && isDrawn(layer, kLayers, context);
    };
    const Points polygon =
        isWanted("convex-hull") || isWanted("elevated-polygon") ? elevated(curve.points, curve.times) : Points{};
    Figure figure;
    if (isWanted("convex-hull"))
        figure.layers.push_back(convexHullLayer(polygon));
    if (isWanted("all-polygons"))
        figure.layers.push_back(allPolygonsLayer(curve));
    figure.layers.push_back({"control-polygon", {{polyline(curve.points), Role::controlPolygon}}});
    if (isWanted("elevated-polygon") && curve.times > 0)
        figure.layers.push_back(
            {"elevated-polygon", {{polyline(polygon), Role::derivedPolygon}}, {{polygon, Role::derivedPolygon}}});
    if (isWanted("end-tangents"))
        figure.layers.push_back(endTangentsLayer(curve.points));
    if (!isIncomplete(curve))
        figure.layers.push_back(
            {kCurveLayer, {{singleCurve(curve.points), Role::curve, 0, 1, curve.style, context.curve}}});
    figure.layers.push_back({"points", {}, {{curve.points, Role::point}}});
    figure.layers.push_back({"labels", {}, {}, indexedLabels("b", curve.points)});
    return figure;
}

std::uint64_t drawingSteps(const ElevationCurve& curve) {
    constexpr std::uint64_t kEvaluating = 3; // the curve's box, by the square of its points
    constexpr std::uint64_t kElevated = 6;
    const std::uint64_t count = curve.points.size();
    return kEvaluating * count * count + kElevated * derivedPointCount(curve);
}

} // namespace kriva
