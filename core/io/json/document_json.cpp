#include "core/io/json/document_json.h"

#include "core/curve/json/json_format.h"
#include "core/curve/json/style_json.h"
#include "core/document/limit_check.h"

#include <algorithm>

namespace kriva {
namespace {

template <std::size_t... Index>
SheetIndex oneOfSheets(const JsonNode& node, std::index_sequence<Index...>) {
    return node.oneOf<SheetIndex>({{sheetName(Index), Index}...});
}

std::vector<std::string_view> layerNames(SheetIndex sheet) {
    std::vector<std::string_view> names;
    for (const LayerInfo& layer : layersOf(sheet))
        names.push_back(layer.name);
    return names;
}

std::array<std::string_view, kSheetCount> sheetNames() {
    std::array<std::string_view, kSheetCount> names;
    for (SheetIndex index = 0; index < kSheetCount; ++index)
        names[index] = sheetName(index);
    return names;
}

void readSheet(const JsonNode& node, SheetIndex index, Sheet& sheet) {
    const JsonObject object(node, {"curves", "view"});
    if (const JsonNode* curves = object.find("curves")) {
        sheet.curves.reserve(curves->listSize(limits::kCurvesInSheet));
        curves->forEachElement([&](const JsonNode& element) {
            Curve curve = emptyCurve(index);
            std::visit([&](auto& c) { readCurve(element, c); }, curve);
            sheet.curves.push_back(std::move(curve));
        });
    }
    if (const JsonNode* view = object.find("view"))
        readView(*view, sheet.view, layerNames(index), viewSettings());
    const int lastCurve = std::max(0, static_cast<int>(sheet.curves.size()) - 1);
    sheet.view.activeCurve = std::min(sheet.view.activeCurve, lastCurve);
    if (std::optional<FileError> error = sheetLimitError(sheet))
        object.require("curves").refuse(error->problem, error->numbers);
}

/// The first with a curve; the first of all where none has one.
SheetIndex sheetToOpenOn(const Document& document) {
    const auto found = std::ranges::find_if(document.sheets, [](const Sheet& sheet) { return !sheet.curves.empty(); });
    return found == document.sheets.end() ? 0 : static_cast<SheetIndex>(found - document.sheets.begin());
}

Document readChecked(const JsonNode& root) {
    const JsonObject object(root, {"format", "version", "title", "active", "sheets"});
    requireFormat(object, "kriva", kFormatVersion);
    Document document;
    if (const JsonNode* title = object.find("title"))
        document.title = title->text();
    const JsonNode* active = object.find("active");
    if (active)
        document.active = readSheetName(*active);
    if (const JsonNode* sheets = object.find("sheets")) {
        const JsonObject byName(*sheets, sheetNames());
        for (SheetIndex index = 0; index < kSheetCount; ++index)
            if (const JsonNode* sheet = byName.find(sheetName(index)))
                readSheet(*sheet, index, document.sheets[index]);
    }
    if (!active)
        document.active = sheetToOpenOn(document);
    return document;
}

} // namespace

SheetIndex readSheetName(const JsonNode& node) {
    return oneOfSheets(node, std::make_index_sequence<kSheetCount>());
}

std::variant<Document, FileError> readDocument(std::string_view text) {
    return readJson(text, readChecked);
}

std::string writeDocument(const Document& document, int linesDownTo) {
    JsonWriter json(JsonWriter::Digits::shortest, linesDownTo);
    json.beginObject().member("format", "kriva").member("version", kFormatVersion);
    json.member("title", std::string_view(document.title)).member("active", sheetName(document.active));
    json.key("sheets").beginObject();
    for (SheetIndex index = 0; index < kSheetCount; ++index) {
        const Sheet& sheet = document.sheets[index];
        if (sheet == Sheet{})
            continue;
        json.key(sheetName(index)).beginObject().key("curves").beginList();
        for (const Curve& curve : sheet.curves)
            std::visit([&](const auto& c) { writeCurve(json, c); }, curve);
        json.endList();
        if (sheet.view != SheetView{})
            writeView(json, sheet.view, viewSettings());
        json.endObject();
    }
    json.endObject().endObject();
    return std::move(json).take();
}

} // namespace kriva
