#include "core/io/svg/drawn_sheet.h"

#include "core/curve/json/json_format.h"
#include "core/curve/json/json_writer.h"
#include "core/io/json/document_json.h"

#include <algorithm>

namespace kriva {
namespace {

/// More than any page that is written has, so that a hostile file has no say.
constexpr int kMostDecimals = 400;

DrawnSheet readChecked(const JsonNode& root) {
    const JsonObject object(root, {"sheet", "curves", "mmPerUnit", "margin", "corner", "decimals"});
    DrawnSheet drawn;
    drawn.sheet = readSheetName(object.require("sheet"));
    const JsonNode& curves = object.require("curves");
    drawn.curves.reserve(curves.listSize(limits::kCurvesInSheet));
    curves.forEachElement([&](const JsonNode& curve) {
        drawn.curves.push_back(curve.wholeNumber(0, static_cast<int>(limits::kCurvesInSheet) - 1));
    });
    drawn.mmPerUnit = object.require("mmPerUnit").numberBetween(0, std::numeric_limits<double>::infinity());
    drawn.margin = object.require("margin").number(0, kMostPageSide);
    drawn.corner = object.require("corner").point();
    drawn.decimals = object.require("decimals").wholeNumber(0, kMostDecimals);
    return drawn;
}

} // namespace

DrawnSheet drawnSheetOf(const Drawing& drawing, int decimals) {
    DrawnSheet drawn;
    drawn.sheet = *drawing.sheet;
    const Page& page = drawing.page;
    drawn.mmPerUnit = page.mmPerUnit;
    drawn.margin = page.margin;
    drawn.corner = {page.box.xmin, page.box.ymax};
    drawn.decimals = decimals;
    const auto layer = std::ranges::find(drawing.figure.layers, kCurveLayer, &Layer::name);
    if (layer == drawing.figure.layers.end())
        return drawn;
    for (const Stroke& stroke : layer->strokes)
        if (drawn.curves.empty() || drawn.curves.back() != stroke.curve)
            drawn.curves.push_back(stroke.curve);
    return drawn;
}

std::string writeDrawnSheet(const DrawnSheet& drawn) {
    JsonWriter json(JsonWriter::Digits::shortest, 0);
    json.beginObject().member("sheet", sheetName(drawn.sheet)).member("curves", drawn.curves);
    json.member("mmPerUnit", drawn.mmPerUnit).member("margin", drawn.margin);
    json.member("corner", drawn.corner).member("decimals", drawn.decimals).endObject();
    std::string text = std::move(json).take();
    text.pop_back(); // without the end of its line
    return text;
}

std::optional<DrawnSheet> readDrawnSheet(std::string_view json) {
    auto read = readJson(json, readChecked);
    if (std::holds_alternative<FileError>(read))
        return {};
    return std::get<DrawnSheet>(std::move(read));
}

Page pageOf(const DrawnSheet& drawn) {
    Page page;
    page.margin = drawn.margin;
    page.mmPerUnit = drawn.mmPerUnit;
    page.box.xmin = page.box.xmax = drawn.corner.x;
    page.box.ymin = page.box.ymax = drawn.corner.y;
    return page;
}

Point inDocument(const DrawnSheet& drawn, Point onPage) {
    return {drawn.corner.x + (onPage.x - drawn.margin) / drawn.mmPerUnit,
            drawn.corner.y - (onPage.y - drawn.margin) / drawn.mmPerUnit};
}

} // namespace kriva
