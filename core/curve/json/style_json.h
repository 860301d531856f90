#pragma once

#include "core/curve/json/json_node.h"
#include "core/curve/json/json_writer.h"
#include "core/figure/style/view_setting.h"

namespace kriva {

void readStyle(const JsonNode& node, CurveStyle& style);
void readView(const JsonNode& node, CurveView& view);
/// `layers`: the names of the layers that the sheet has; `settings`: those that a view may have.
void readView(const JsonNode& node, SheetView& view, std::span<const std::string_view> layers,
              std::span<const ViewSetting> settings);
void writeStyle(JsonWriter& json, const CurveStyle& style);
void writeView(JsonWriter& json, const CurveView& view);
void writeView(JsonWriter& json, const SheetView& view, std::span<const ViewSetting> settings);

/// Reads `name`, `style` and `view`, which every curve has.
template <class Curve>
void readCommon(const JsonObject& object, Curve& curve) {
    if (const JsonNode* name = object.find("name"))
        curve.name = name->text();
    if (const JsonNode* style = object.find("style"))
        readStyle(*style, curve.style);
    if (const JsonNode* view = object.find("view"))
        readView(*view, curve.view);
}

template <class Curve>
void writeName(JsonWriter& json, const Curve& curve) {
    json.member("name", std::string_view(curve.name));
}

/// Writes `style` and `view` where they say something.
template <class Curve>
void writeStyleAndView(JsonWriter& json, const Curve& curve) {
    if (curve.style != CurveStyle{})
        writeStyle(json, curve.style);
    if (curve.view != CurveView{})
        writeView(json, curve.view);
}

} // namespace kriva
