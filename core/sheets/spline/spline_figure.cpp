#include "core/bezier/evaluate.h"
#include "core/figure/labels.h"
#include "core/sheets/spline/editing/joins.h"
#include "core/sheets/spline/layers/curvature_comb.h"
#include "core/sheets/spline/layers/spline_layers.h"
#include "core/sheets/spline/spline.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace kriva {
namespace {

constexpr std::array kLayers{
    LayerInfo{"curvature-comb", translatable("Caption", "Curvature comb"), false, true},
    LayerInfo{"all-rules", Caption::allRules, false, true},
    LayerInfo{"control-polygon", Caption::controlPolygon},
    LayerInfo{kCurveLayer, Caption::curve},
    LayerInfo{"polyline", translatable("Caption", "De Casteljau polyline"), false, true},
    LayerInfo{"end-derivatives", translatable("Caption", "End derivatives"), true, true},
    LayerInfo{"handles", translatable("Caption", "Handles")},
    LayerInfo{"knots", translatable("Caption", "Knots")},
    LayerInfo{"inflections", translatable("Caption", "Inflections"), false, true},
    LayerInfo{"crossings", translatable("Caption", "Crossings"), true, false, 0, true},
    LayerInfo{"continuity", translatable("Caption", "Continuity at the knots"), false, true},
    LayerInfo{"labels", Caption::labels, true, true},
};

Points knotPoints(const SplineCurve& curve) {
    Points points;
    points.reserve(curve.knots.size());
    for (const SplineKnot& knot : curve.knots)
        points.push_back(knot.at);
    return points;
}

/// All segments' polygons in one stroke, since each starts where the one before ended.
Layer polygonLayer(const Path& path) {
    Path polygon{path.points, std::vector<int>(path.points.size() - 1, 1), false};
    Layer layer{"control-polygon"};
    layer.strokes.push_back({std::move(polygon), Role::controlPolygon});
    return layer;
}

Layer curveLayer(const SplineCurve& curve, Path path, const FigureContext& context) {
    Layer layer{kCurveLayer};
    layer.strokes.push_back({std::move(path), Role::curve, 0, 1, curve.style, context.curve});
    return layer;
}

/// The handles in the order of the curve.
Points handlePoints(std::span<const KnotHandles> handles) {
    Points points;
    points.reserve(2 * handles.size());
    for (std::size_t i = 0; i < handles.size(); ++i) {
        if (handles[i].out)
            points.push_back(*handles[i].out);
        const std::size_t next = (i + 1) % handles.size();
        if (handles[next].in)
            points.push_back(*handles[next].in);
    }
    return points;
}

/// The control polygon of a cubic has the lines to its handles; higher degrees get their own.
Layer handlesLayer(const SplineCurve& curve, const Path& path, std::span<const KnotHandles> handles) {
    Layer layer{"handles"};
    layer.marks.push_back({handlePoints(handles), Role::handle});
    if (innerCount(curve.degree) == 0)
        return layer;
    for (std::size_t i = 0; i < handles.size(); ++i) {
        const Point at = curve.knots[i].at;
        const Points line = {handles[i].in.value_or(at), at, handles[i].out.value_or(at)};
        layer.strokes.push_back({polyline(line), Role::handle});
    }
    Points inner;
    forEachPiece(
        path, [&](std::span<const Point> segment) { std::ranges::copy(innerOf(segment), std::back_inserter(inner)); });
    layer.marks.push_back({std::move(inner), Role::point});
    return layer;
}

Layer endDerivativesLayer(const SplineCurve& curve, std::span<const KnotHandles> handles) {
    Layer layer{"end-derivatives"};
    const EndDerivatives ends = endDerivatives(curve, handles);
    const auto addArrow = [&](Point from, std::optional<Vector> derivative) {
        if (!derivative)
            return;
        const Points arrow = {from, from + *derivative};
        layer.strokes.push_back({polyline(arrow), Role::derivative});
        layer.marks.push_back({{arrow.back()}, Role::derivative});
    };
    addArrow(curve.knots.front().at, ends.start);
    addArrow(curve.knots.back().at, ends.end);
    return layer;
}

/// K_i at the knots, P_i at the handles (the middle points of parabolas) and c_i half way along the segments.
Layer labelsLayer(const SplineCurve& curve, const Path& path, std::span<const KnotHandles> handles) {
    Layer layer{"labels", {}, {}, indexedLabels("K", knotPoints(curve))};
    Points placed = handlePoints(handles);
    Points halfway;
    forEachPiece(path, [&](std::span<const Point> segment) {
        if (curve.degree == 2)
            placed.push_back(segment[1]);
        halfway.push_back(evaluate(segment, 0.5));
    });
    for (const std::vector<Label>& labels : {indexedLabels("P", placed, Role::handle), indexedLabels("c", halfway)})
        layer.labels.insert(layer.labels.end(), labels.begin(), labels.end());
    return layer;
}

/// What lies under the curve.
void addBeneath(Figure& figure, const SplineCurve& curve, const FigureContext& context) {
    if (isDrawn("curvature-comb", kLayers, context))
        figure.layers.push_back(
            curvatureCombLayer(segmentsOf(curve), shapesOf(curve), numberOf(context.view, kCombScale)));
    if (isDrawn("all-rules", kLayers, context))
        figure.layers.push_back(allRulesLayer(curve));
}

/// What is marked on the curve.
void addOnTop(Figure& figure, const SplineCurve& curve, const FigureContext& context) {
    const bool hasInflections = isDrawn("inflections", kLayers, context);
    const bool hasContinuity = isDrawn("continuity", kLayers, context) && curve.knots.size() <= kMostLabelledPoints;
    if (!hasInflections && !hasContinuity)
        return;
    const SplineChain solved = solveSpline(curve);
    if (hasInflections)
        figure.layers.push_back(inflectionsLayer(curve, solved, shapesOf(curve)));
    if (hasContinuity)
        figure.layers.push_back(continuityLayer(curve, solved));
}

} // namespace

std::span<const LayerInfo> layersOf(const SplineCurve&) {
    return kLayers;
}

std::span<const ViewSetting> viewSettingsOf(const SplineCurve&) {
    static constexpr std::array kSettings{kCombScale, kPolylinePoints};
    return kSettings;
}

Figure figureOf(const SplineCurve& curve, const FigureContext& context) {
    Path path = pathOf(curve);
    const std::vector<KnotHandles> handles = knotHandles(curve);
    Figure figure;
    std::optional<Layer> labels;
    if (context.isActive && curve.knots.size() <= kMostLabelledPoints)
        labels = labelsLayer(curve, path, handles);
    if (!isIncomplete(curve)) {
        addBeneath(figure, curve, context);
        figure.layers.push_back(polygonLayer(path));
        Layer ofHandles = handlesLayer(curve, path, handles);
        figure.layers.push_back(curveLayer(curve, std::move(path), context));
        if (isDrawn("polyline", kLayers, context))
            figure.layers.push_back(
                polylineLayer(segmentsOf(curve), static_cast<int>(numberOf(context.view, kPolylinePoints))));
        if (context.isActive)
            figure.layers.push_back(endDerivativesLayer(curve, handles));
        figure.layers.push_back(std::move(ofHandles));
    }
    Layer knots{"knots"};
    knots.marks.push_back({knotPoints(curve), Role::knot});
    figure.layers.push_back(std::move(knots));
    if (!isIncomplete(curve))
        addOnTop(figure, curve, context);
    if (labels)
        figure.layers.push_back(std::move(*labels));
    return figure;
}

std::uint64_t drawingSteps(const SplineCurve& curve) {
    constexpr std::uint64_t kSegment = 20; // with what a view may show of it besides
    return kSegment * curve.knots.size();
}

} // namespace kriva
