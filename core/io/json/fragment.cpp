#include "core/io/json/fragment.h"

#include "core/curve/json/json_format.h"
#include "core/curve/json/json_writer.h"
#include "core/document/limit_check.h"
#include "core/io/json/document_json.h"

namespace kriva {
namespace {

constexpr std::string_view kFormat = "kriva-fragment";
constexpr std::string_view kPoints = "points";
constexpr std::string_view kCurve = "curve";

Fragment readCheckedFragment(const JsonNode& root) {
    const JsonObject object(root, {"format", "version", "content", "sheet", "curve"});
    requireFormat(object, kFormat, kFormatVersion);
    Fragment fragment;
    fragment.content = object.require("content").oneOf<Fragment::Content>(
        {{kPoints, Fragment::Content::points}, {kCurve, Fragment::Content::curve}});
    const SheetIndex sheet = readSheetName(object.require("sheet"));
    fragment.curve = emptyCurve(sheet);
    std::visit([&](auto& curve) { readCurve(object.require("curve"), curve); }, fragment.curve);
    if (std::optional<FileError> error = sheetLimitError(Sheet{{fragment.curve}, {}}))
        throw Refused{std::move(*error)};
    return fragment;
}

} // namespace

Fragment fragmentOf(const Curve& curve, std::span<const int> indices) {
    std::vector<int> others;
    auto next = indices.begin();
    for (int i = 0; i < static_cast<int>(pointCount(curve)); ++i) {
        if (next != indices.end() && *next == i)
            ++next;
        else
            others.push_back(i);
    }
    return {Fragment::Content::points, withPointsRemoved(curve, others).curve};
}

std::string writeFragment(const Fragment& fragment) {
    JsonWriter json(JsonWriter::Digits::shortest, 0);
    json.beginObject().member("format", kFormat).member("version", kFormatVersion);
    json.member("content", fragment.content == Fragment::Content::points ? kPoints : kCurve);
    json.member("sheet", sheetName(fragment.curve.index())).key("curve");
    std::visit([&](const auto& curve) { writeCurve(json, curve); }, fragment.curve);
    json.endObject();
    return std::move(json).take();
}

std::variant<Fragment, FileError> readFragment(std::string_view text) {
    return readJson(text, readCheckedFragment);
}

} // namespace kriva
