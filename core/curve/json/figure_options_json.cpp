#include "core/curve/json/figure_options_json.h"

namespace kriva {
namespace {

void read(const JsonObject& object, std::string_view key, bool& value) {
    if (const JsonNode* found = object.find(key))
        value = found->trueOrFalse();
}

void readDrawing(const JsonObject& object, DrawingOptions& drawing, std::span<const std::string_view> layers) {
    if (const JsonNode* margin = object.find("margin"))
        drawing.margin = margin->number(0, kMostPageSide);
    if (const JsonNode* width = object.find("width"))
        drawing.width = width->numberBetween(2 * drawing.margin, 3 * kMostPageSide);
    if (const JsonNode* scale = object.find("mmPerUnit"))
        drawing.mmPerUnit = scale->number(kLeastScale, kMostScale);
    if (const JsonNode* chosen = object.find("layers")) {
        const JsonObject names(*chosen, layers);
        drawing.layers.emplace();
        for (const std::string_view name : layers)
            if (const JsonNode* isChosen = names.find(name); isChosen && isChosen->trueOrFalse())
                drawing.layers->emplace_back(name);
    }
    read(object, "labels", drawing.hasLabels);
    if (const JsonNode* theme = object.find("theme"))
        drawing.theme = theme->oneOf(kThemeNames);
}

void readFrames(const JsonObject& object, FigureFileOptions& options) {
    const auto readPlaces = [&](std::string_view key, FramePlace::Over over, double most) {
        if (const JsonNode* places = object.find(key)) {
            options.frames.clear();
            options.frames.reserve(places->listSize(static_cast<std::size_t>(kMostFrames)));
            places->forEachElement([&](const JsonNode& at) { options.frames.push_back({over, at.number(0, most)}); });
        }
    };
    readPlaces("stages", FramePlace::Over::stage, kMostStage);
    readPlaces("t", FramePlace::Over::t, 1);
    read(object, "animated", options.isAnimated);
    if (const JsonNode* seconds = object.find("seconds"))
        options.frameSeconds = seconds->number(kLeastFrameSeconds, kMostFrameSeconds);
}

void write(JsonWriter& json, std::string_view key, bool value, bool usual) {
    if (value != usual)
        json.member(key, value);
}

void writeFrames(JsonWriter& json, const FigureFileOptions& options) {
    const FigureFileOptions usual;
    std::vector<double> places;
    for (const FramePlace& place : options.frames)
        places.push_back(place.at);
    if (!places.empty())
        json.member(options.frames.front().over == FramePlace::Over::t ? "t" : "stages", places);
    write(json, "animated", options.isAnimated, usual.isAnimated);
    if (options.frameSeconds != usual.frameSeconds)
        json.member("seconds", options.frameSeconds);
}

} // namespace

FigureFileOptions readFigureOptions(const JsonNode& node, std::span<const std::string_view> layers) {
    const JsonObject object(node, {"format", "width", "mmPerUnit", "margin", "layers", "labels", "theme", "document",
                                   "decimals", "inkscapeLayers", "outlines", "dpi", "transparent", "fragment", "stages",
                                   "t", "animated", "seconds"});
    FigureFileOptions options;
    if (const JsonNode* format = object.find("format"))
        options.format = format->oneOf(kFormatNames);
    readDrawing(object, options.drawing, layers);
    read(object, "document", options.holdsDocument);
    if (const JsonNode* decimals = object.find("decimals"))
        options.decimals = decimals->wholeNumber(0, kMostDecimals);
    read(object, "inkscapeLayers", options.hasInkscapeLayers);
    read(object, "outlines", options.hasOutlines);
    if (const JsonNode* dpi = object.find("dpi"))
        options.dpi = dpi->wholeNumber(kLeastDpi, kMostDpi);
    read(object, "transparent", options.isTransparent);
    bool isFragment = false;
    read(object, "fragment", isFragment);
    options.tikz = isFragment ? TikzKind::fragment : TikzKind::standalone;
    readFrames(object, options);
    return options;
}

void writeFigureOptions(JsonWriter& json, const FigureFileOptions& options) {
    const FigureFileOptions usual;
    json.beginObject();
    if (options.format != usual.format)
        json.member("format", wordOf(options.format, kFormatNames));
    if (options.drawing.width)
        json.member("width", *options.drawing.width);
    if (options.drawing.mmPerUnit)
        json.member("mmPerUnit", *options.drawing.mmPerUnit);
    if (options.drawing.margin != usual.drawing.margin)
        json.member("margin", options.drawing.margin);
    if (options.drawing.layers) {
        json.key("layers").beginObject();
        for (const std::string& name : *options.drawing.layers)
            json.member(name, true);
        json.endObject();
    }
    write(json, "labels", options.drawing.hasLabels, usual.drawing.hasLabels);
    if (options.drawing.theme != usual.drawing.theme)
        json.member("theme", wordOf(options.drawing.theme, kThemeNames));
    write(json, "document", options.holdsDocument, usual.holdsDocument);
    if (options.decimals)
        json.member("decimals", *options.decimals);
    write(json, "inkscapeLayers", options.hasInkscapeLayers, usual.hasInkscapeLayers);
    write(json, "outlines", options.hasOutlines, usual.hasOutlines);
    if (options.dpi != usual.dpi)
        json.member("dpi", options.dpi);
    write(json, "transparent", options.isTransparent, usual.isTransparent);
    write(json, "fragment", options.tikz == TikzKind::fragment, false);
    writeFrames(json, options);
    json.endObject();
}

} // namespace kriva
