#include "core/curve/limits.h"
#include "core/figure/labels.h"
#include "core/sheets/subdivision/subdivision.h"

#include <algorithm>
#include <array>

namespace kriva {
namespace {

constexpr std::array kLayers{
    LayerInfo{"control-polygon", Caption::controlPolygon},
    LayerInfo{"further-constructions", translatable("Caption", "De Casteljau schemes at further t"), true, true},
    LayerInfo{"construction", Caption::construction, true, true},
    LayerInfo{"pieces", translatable("Caption", "Pieces"), true, true},
    LayerInfo{"partial-curves", translatable("Caption", "Curves of degree n − 1"), false, true},
    LayerInfo{"left", Caption::leftPolygon, true, true},
    LayerInfo{"right", Caption::rightPolygon, true, true},
    LayerInfo{kCurveLayer, Caption::curve},
    LayerInfo{"points", Caption::points},
    LayerInfo{"curve-point", translatable("Caption", "Point of the curve"), true, true},
    LayerInfo{"blossom", Caption::blossom, true, true},
    LayerInfo{"labels", Caption::labels, true, true},
    LayerInfo{"part-labels", translatable("Caption", "Labels of left and right"), true, true},
};

/// The rows between the control polygon and the last point.
Layer construction(std::string_view name, const Triangle& triangle) {
    Layer layer{name};
    for (std::size_t r = 1; r + 1 < triangle.size(); ++r) {
        const int level = static_cast<int>(r);
        layer.strokes.push_back({polyline(triangle[r]), Role::construction, level});
        layer.marks.push_back({triangle[r], Role::construction, level});
    }
    return layer;
}

/// The schemes at the further parameters, each fainter than the one before, and their points of the curve.
Layer furtherConstructions(const Points& polygon, std::span<const double> parameters) {
    constexpr double kFirst = 0.55;
    constexpr double kFading = 0.85;
    constexpr double kFaintest = 0.2;
    Layer layer{"further-constructions"};
    Points places;
    double strength = kFirst;
    for (const double t : parameters) {
        const Triangle triangle = deCasteljau(polygon, t);
        for (std::size_t r = 1; r + 1 < triangle.size(); ++r)
            layer.strokes.push_back({polyline(triangle[r]), Role::construction, static_cast<int>(r), strength});
        places.push_back(triangle.back().front());
        strength = std::max(kFaintest, kFading * strength);
    }
    if (!places.empty())
        layer.marks.push_back({std::move(places), Role::curvePoint});
    return layer;
}

/// All pieces in one stroke, since each starts where the one before ended; marks show where.
Layer piecesLayer(const SubdivisionCurve& curve) {
    const std::vector<Points> all = pieces(curve);
    Points polygon{all.front().front()};
    Points ends = polygon;
    for (const Points& piece : all) {
        polygon.insert(polygon.end(), piece.begin() + 1, piece.end());
        ends.push_back(piece.back());
    }
    return {"pieces", {{polyline(polygon), Role::derivedPolygon}}, {{ends, Role::derivedPolygon}}};
}

/// The two curves of degree n - 1 through all points but the last and all but the first: at t, the point of the curve
/// divides the line from one to the other.
Layer partialCurves(const Subdivision& subdivision) {
    const std::span<const Point> polygon = subdivision.polygon;
    if (polygon.size() < 3)
        return {"partial-curves"};
    const Points& line = subdivision.triangle[polygon.size() - 2];
    return {"partial-curves",
            {{singleCurve(polygon.first(polygon.size() - 1)), Role::left},
             {singleCurve(polygon.last(polygon.size() - 1)), Role::right},
             {polyline(line), Role::construction, static_cast<int>(polygon.size()) - 2}},
            {{line, Role::construction, static_cast<int>(polygon.size()) - 2}}};
}

Layer half(std::string_view name, const Points& polygon, Role role) {
    return {name, {{polyline(polygon), role}}, {{polygon, role}}};
}

/// "b[t1,t2,t3]"
std::string blossomName(std::size_t degree) {
    std::string arguments;
    for (std::size_t i = 1; i <= degree; ++i) {
        const bool isNamed = degree <= 3 || i == 1 || i == degree;
        if (isNamed)
            arguments.append(i == 1 ? "t" : ",t").append(decimal(static_cast<int>(i)));
        else if (i == 2)
            arguments += ",...";
    }
    return "b[" + arguments + "]";
}

/// Arguments far from [0, 1] throw the blossom so far away that no canvas reaches it.
bool isWithinLimits(const Triangle& triangle) {
    return std::ranges::all_of(triangle, [](const Points& row) {
        return std::ranges::all_of(
            row, [](Point p) { return std::abs(p.x) <= limits::kNumber && std::abs(p.y) <= limits::kNumber; });
    });
}

/// The scheme with one argument after the other, and where it ends.
Layer blossomLayer(const SubdivisionCurve& curve, const Points& polygon) {
    if (!curve.blossom)
        return {"blossom"};
    const Triangle triangle = deCasteljau(polygon, *curve.blossom);
    if (!isWithinLimits(triangle))
        return {"blossom"};
    Layer layer = construction("blossom", triangle);
    layer.marks.push_back({triangle.back(), Role::curvePoint, 1});
    layer.labels.push_back({triangle.back().front(), Caption::none, blossomName(polygon.size() - 1), ""});
    return layer;
}

/// b_i, and behind those that stand several times how often.
std::vector<Label> pointLabels(const SubdivisionCurve& curve) {
    std::vector<Label> labels = indexedLabels("b", curve.points);
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (curve.multiplicity[i] > 1)
            labels[i].suffix = "\u00d7" + decimal(curve.multiplicity[i]);
    return labels;
}

/// l_i and r_i, each on its own side: l_n and r_0 are one point, as are l_0 and b_0, r_n and b_n.
std::vector<Label> partLabels(const Halves& halves) {
    std::vector<Label> labels = indexedLabels("l", halves.left, Role::left);
    for (Label& label : labels)
        label.side = LabelSide::belowLeft;
    for (Label& label : indexedLabels("r", halves.right, Role::right)) {
        label.side = LabelSide::belowRight;
        labels.push_back(std::move(label));
    }
    return labels;
}

void addPolygons(Figure& figure, const SubdivisionCurve& curve, const Subdivision& cut, const FigureContext& context) {
    const std::span<const double> further = numbersOf(context.view, kFurtherParameters);
    if (isDrawn("further-constructions", kLayers, context))
        figure.layers.push_back(furtherConstructions(cut.polygon, further));
    figure.layers.push_back(construction("construction", cut.triangle));
    if (isDrawn("pieces", kLayers, context))
        figure.layers.push_back(piecesLayer(curve));
    figure.layers.push_back(partialCurves(cut));
    figure.layers.push_back(half("left", cut.halves.left, Role::left));
    figure.layers.push_back(half("right", cut.halves.right, Role::right));
}

void addPlaces(Figure& figure, const SubdivisionCurve& curve, const Subdivision& cut) {
    figure.layers.push_back({"curve-point", {}, {{cut.triangle.back(), Role::curvePoint}}});
    figure.layers.push_back(blossomLayer(curve, cut.polygon));
}

} // namespace

std::span<const LayerInfo> layersOf(const SubdivisionCurve&) {
    return kLayers;
}

Figure figureOf(const SubdivisionCurve& curve, const FigureContext& context) {
    const bool isCut = context.isActive && !isIncomplete(curve);
    const Subdivision cut = isCut ? subdivide(curve) : Subdivision{};
    Figure figure;
    figure.layers.push_back({"control-polygon", {{polyline(curve.points), Role::controlPolygon}}});
    if (isCut)
        addPolygons(figure, curve, cut, context);
    if (!isIncomplete(curve))
        figure.layers.push_back(
            {kCurveLayer, {{singleCurve(controlPolygon(curve)), Role::curve, 0, 1, curve.style, context.curve}}});
    figure.layers.push_back({"points", {}, {{curve.points, Role::point}}});
    if (isCut)
        addPlaces(figure, curve, cut);
    figure.layers.push_back({"labels", {}, {}, pointLabels(curve)});
    if (isCut)
        figure.layers.push_back({"part-labels", {}, {}, partLabels(cut.halves)});
    return figure;
}

std::uint64_t drawingSteps(const SubdivisionCurve& curve) {
    constexpr std::uint64_t kScheme = 3; // de Casteljau's, by the square of the points
    constexpr std::uint64_t kDerived = 5;
    const std::uint64_t count = controlPointCount(curve);
    return kScheme * count * count + kDerived * derivedPointCount(curve);
}

} // namespace kriva
