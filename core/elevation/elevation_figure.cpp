#include "core/elevation/elevation_figure.h"

#include "core/figure/labels.h"

namespace kriva {
namespace {

constexpr std::array kLayers{
    LayerInfo{"control-polygon", Caption::controlPolygon},
    LayerInfo{"elevated-polygon", Caption::elevatedPolygon, true, true},
    LayerInfo{"curve", Caption::curve},
    LayerInfo{"points", Caption::points},
    LayerInfo{"labels", Caption::labels, true, true},
};

} // namespace

std::span<const LayerInfo> layersOf(const ElevationCurve&) {
    return kLayers;
}

Figure figureOf(const ElevationCurve& curve, const FigureContext& context) {
    Figure figure;
    figure.layers.push_back({"control-polygon", {{polyline(curve.points), Role::controlPolygon}}});
    if (!isIncomplete(curve)) {
        if (context.isActive && curve.times > 0) {
            const Points polygon = elevate(curve).polygon;
            figure.layers.push_back(
                {"elevated-polygon", {{polyline(polygon), Role::derivedPolygon}}, {{polygon, Role::derivedPolygon}}});
        }
        figure.layers.push_back(
            {"curve", {{singleCurve(curve.points), Role::curve, 0, 1, curve.style, context.curve}}});
    }
    figure.layers.push_back({"points", {}, {{curve.points, Role::point}}});
    figure.layers.push_back({"labels", {}, {}, indexedLabels("b", curve.points)});
    return figure;
}

} // namespace kriva
