#include "core/curve/json/style_json.h"

#include "core/curve/json/figure_options_json.h"
#include "core/figure/style/color.h"

#include <utility>

namespace kriva {
namespace {

const std::initializer_list<std::pair<std::string_view, LineDash>> kDashes = {{"solid", LineDash::solid},
                                                                              {"dashed", LineDash::dashed},
                                                                              {"dotted", LineDash::dotted},
                                                                              {"dash-dot", LineDash::dashDot}};

const std::initializer_list<std::pair<std::string_view, Marker>> kMarkers = {
    {"none", Marker::none}, {"circle", Marker::circle}, {"square", Marker::square}, {"diamond", Marker::diamond}};

std::vector<double> readNumbers(const JsonNode& node, const ViewSetting& setting) {
    if (setting.mostNumbers == 0 && setting.isWhole)
        return {static_cast<double>(node.wholeNumber(static_cast<int>(setting.least), static_cast<int>(setting.most)))};
    if (setting.mostNumbers == 0)
        return {node.number(setting.least, setting.most)};
    std::vector<double> numbers;
    numbers.reserve(node.listSize(setting.mostNumbers));
    node.forEachElement(
        [&](const JsonNode& number) { numbers.push_back(number.numberBetween(setting.least, setting.most)); });
    return numbers;
}

} // namespace

void readStyle(const JsonNode& node, CurveStyle& style) {
    const JsonObject object(node, {"color", "width", "dash", "marker", "labels"});
    if (const JsonNode* color = object.find("color")) {
        style.color = colorFromHex(color->text());
        if (!style.color)
            color->refuse(FileProblem::expectedColor);
    }
    if (const JsonNode* width = object.find("width"))
        style.width = width->number(kLeastWidth, kMostWidth);
    if (const JsonNode* dash = object.find("dash"))
        style.dash = dash->oneOf(kDashes);
    if (const JsonNode* marker = object.find("marker"))
        style.marker = marker->oneOf(kMarkers);
    if (const JsonNode* labels = object.find("labels"))
        style.hasLabels = labels->trueOrFalse();
}

void readView(const JsonNode& node, CurveView& view) {
    const JsonObject object(node, {"shown"});
    if (const JsonNode* shown = object.find("shown"))
        view.isShown = shown->trueOrFalse();
}

void readView(const JsonNode& node, SheetView& view, std::span<const std::string_view> layers,
              std::span<const ViewSetting> settings) {
    std::vector<std::string_view> keys{"activeCurve", "layers", "mmPerUnit", "export"};
    for (const ViewSetting& setting : settings)
        keys.push_back(setting.name);
    const JsonObject object(node, keys);
    if (const JsonNode* active = object.find("activeCurve"))
        view.activeCurve = active->wholeNumber(0, static_cast<int>(limits::kCurvesInSheet) - 1);
    if (const JsonNode* shown = object.find("layers")) {
        const JsonObject shownLayers(*shown, layers);
        for (const std::string_view name : layers)
            if (const JsonNode* isShown = shownLayers.find(name))
                view.layers.emplace(name, isShown->trueOrFalse());
    }
    if (const JsonNode* scale = object.find("mmPerUnit"))
        view.mmPerUnit = scale->number(kLeastScale, kMostScale);
    for (const ViewSetting& setting : settings)
        if (const JsonNode* numbers = object.find(setting.name))
            view = withNumbers(std::move(view), setting, readNumbers(*numbers, setting));
    if (const JsonNode* exported = object.find("export"))
        view.exported = readFigureOptions(*exported, layers);
}

void writeStyle(JsonWriter& json, const CurveStyle& style) {
    json.key("style").beginObject();
    if (style.color)
        json.member("color", std::string_view(hexOf(*style.color)));
    if (style.width)
        json.member("width", *style.width);
    if (style.dash)
        json.member("dash", wordOf(*style.dash, kDashes));
    if (style.marker)
        json.member("marker", wordOf(*style.marker, kMarkers));
    if (!style.hasLabels)
        json.member("labels", false);
    json.endObject();
}

void writeView(JsonWriter& json, const CurveView& view) {
    json.key("view").beginObject().member("shown", view.isShown).endObject();
}

void writeView(JsonWriter& json, const SheetView& view, std::span<const ViewSetting> settings) {
    json.key("view").beginObject();
    if (view.activeCurve != 0)
        json.member("activeCurve", view.activeCurve);
    if (!view.layers.empty()) {
        json.key("layers").beginObject();
        for (const auto& [name, isShown] : view.layers)
            json.member(name, isShown);
        json.endObject();
    }
    if (view.mmPerUnit)
        json.member("mmPerUnit", *view.mmPerUnit);
    for (const ViewSetting& setting : settings) {
        const std::span<const double> numbers = numbersOf(&view, setting);
        if (!numbers.empty() && setting.mostNumbers == 0)
            json.member(setting.name, numbers.front());
        else if (!numbers.empty())
            json.member(setting.name, std::vector(numbers.begin(), numbers.end()));
    }
    if (view.exported) {
        json.key("export");
        writeFigureOptions(json, *view.exported);
    }
    json.endObject();
}

} // namespace kriva
