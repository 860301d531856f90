#include "core/curve/json/style_json.h"
#include "core/curve/limits.h"
#include "core/figure/labels.h"
#include "core/sheets/offset/offset.h"

#include <array>

namespace kriva {
namespace {

constexpr std::array kLayers{
    LayerInfo{"offsets", OffsetCurve::kCaption, true, true},
    LayerInfo{kCurveLayer, Caption::curve},
    LayerInfo{"points", Caption::points},
    LayerInfo{"labels", Caption::labels, true, true},
};

double lengthOf(const Points& polygon) {
    double sum = 0;
    for (std::size_t i = 1; i < polygon.size(); ++i)
        sum += distance(polygon[i - 1], polygon[i]);
    return sum;
}

} // namespace

std::span<const LayerInfo> layersOf(const OffsetCurve&) {
    return kLayers;
}

Figure figureOf(const OffsetCurve& curve, const FigureContext& context) {
    Figure figure;
    if (!isIncomplete(curve)) {
        Layer offsets{"offsets"};
        for (const Points& polygon : offsetPolygons(curve))
            offsets.strokes.push_back({polyline(polygon), Role::derivedPolygon});
        figure.layers.push_back(std::move(offsets));
        figure.layers.push_back(
            {kCurveLayer, {{polyline(curve.points), Role::curve, 0, 1, curve.style, context.curve}}});
    }
    figure.layers.push_back({"points", {}, {{curve.points, Role::point}}});
    figure.layers.push_back({"labels", {}, {}, indexedLabels("q", curve.points)});
    return figure;
}

std::uint64_t drawingSteps(const OffsetCurve& curve) {
    constexpr std::uint64_t kPoint = 2;
    return kPoint * (curve.points.size() + derivedPointCount(curve));
}

std::optional<std::vector<Result>> results(const OffsetCurve& curve, WorkBudget& budget) {
    if (!budget.spend())
        return {};
    return {{{Caption::length, "", lengthOf(curve.points)}, {OffsetCurve::kCaption, "", curve.times}}};
}

std::optional<std::vector<PlotGroup>> plotsOf(const OffsetCurve& curve, WorkBudget& budget) {
    if (isIncomplete(curve))
        return std::vector<PlotGroup>();
    if (!budget.spend())
        return {};
    Plot plot{Caption::length, {.variable = "k"}, {.variable = "l"}, {}};
    Points lengths{{0, lengthOf(curve.points)}};
    for (const Points& polygon : offsetPolygons(curve))
        lengths.push_back({static_cast<double>(lengths.size()), lengthOf(polygon)});
    plot.lines.push_back({polyline(lengths), Role::plotLine, 0, Caption::length});
    return {{{Caption::length, {withAxesFitted(std::move(plot))}}}};
}

std::optional<std::vector<Table>> tablesOf(const OffsetCurve& curve, WorkBudget& budget) {
    if (isIncomplete(curve) || curve.times == 0)
        return std::vector<Table>();
    if (!budget.spend())
        return {};
    Table table{OffsetCurve::kCaption, {{Caption::none, "i", ""}, {Caption::none, "q", "i"}}, {}};
    for (const Point corner : offsetPolygons(curve).back())
        table.rows.push_back({{static_cast<int>(table.rows.size())}, {corner}});
    return {{std::move(table)}};
}

void reportCurve(JsonWriter& json, const OffsetCurve& curve) {
    json.member("length", lengthOf(curve.points)).member("offsets", offsetPolygons(curve));
}

void readCurve(const JsonNode& node, OffsetCurve& curve) {
    const JsonObject object(node, {"name", "points", "distance", "times", "style", "view"});
    if (const JsonNode* points = object.find("points"))
        curve.points = points->points();
    if (const JsonNode* distance = object.find("distance"))
        curve.distance = distance->number();
    if (const JsonNode* times = object.find("times"))
        curve.times = times->wholeNumber(0, limits::kOffsets);
    readCommon(object, curve);
}

void writeCurve(JsonWriter& json, const OffsetCurve& curve) {
    const OffsetCurve usual;
    json.beginObject();
    writeName(json, curve);
    json.member("points", curve.points);
    if (curve.distance != usual.distance)
        json.member("distance", curve.distance);
    if (curve.times != usual.times)
        json.member("times", curve.times);
    writeStyleAndView(json, curve);
    json.endObject();
}

} // namespace kriva
