#include "core/exchange/fragment.h"

#include "core/document/document_json.h"
#include "core/document/json/json_node.h"
#include "core/document/json/json_writer.h"
#include "core/document/limit_check.h"

namespace kriva {
namespace {

constexpr std::string_view kFormat = "kriva-fragment";
constexpr std::string_view kPoints = "points";
constexpr std::string_view kCurve = "curve";

SheetIndex readSheetName(const JsonNode& node) {
    const std::optional<SheetIndex> sheet = sheetNamed(node.text());
    if (sheet)
        return *sheet;
    std::vector<std::string> names;
    for (SheetIndex i = 0; i < kSheetCount; ++i)
        names.emplace_back(sheetName(i));
    node.refuse(FileProblem::expectedOneOf, {}, names);
}

Fragment readChecked(const JsonTape& tape) {
    const JsonNode root(tape);
    const JsonObject object(root, {"format", "version", "content", "sheet", "curve"});
    const JsonNode& format = object.require("format");
    if (format.text() != kFormat)
        format.refuse(FileProblem::foreignFormat);
    const JsonNode& version = object.require("version");
    if (const int number = version.wholeNumber(1, static_cast<int>(limits::kNumber)); number > kFormatVersion)
        version.refuse(FileProblem::unknownVersion, {static_cast<double>(number)});
    Fragment fragment;
    fragment.content = object.require("content").oneOf<Fragment::Content>(
        {{kPoints, Fragment::Content::points}, {kCurve, Fragment::Content::curve}});
    const SheetIndex sheet = readSheetName(object.require("sheet"));
    fragment.curve = emptyCurve(sheet);
    std::visit([&](auto& curve) { readCurve(object.require("curve"), curve); }, fragment.curve);
    if (std::optional<FileError> error = sheetLimitError(Sheet{{fragment.curve}, {}}, sheet))
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
    if (text.size() > limits::kFileBytes) {
        FileError error;
        error.problem = FileProblem::tooLarge;
        error.numbers = {static_cast<double>(limits::kFileBytes)};
        return error;
    }
    std::variant<JsonTape, FileError> tape = parseJson(text);
    if (FileError* error = std::get_if<FileError>(&tape))
        return std::move(*error);
    try {
        return readChecked(std::get<JsonTape>(tape));
    } catch (Refused& refused) {
        return std::move(refused.error);
    }
}

} // namespace kriva
