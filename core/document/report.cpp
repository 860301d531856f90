#include "core/document/report.h"

#include "core/budget/work_budget.h"
#include "core/curve/json/json_writer.h"
#include "core/curve/limits.h"
#include "core/document/limit_check.h"

namespace kriva {
namespace {

/// Why the sheet cannot be reported, which may be seen only on the way.
template <class C>
std::optional<FileError> reportSheetOf(JsonWriter& json, const Sheet& sheet) {
    const std::vector<const C*> curves = curvesOf<C>(sheet);
    json.key("curves").beginList();
    for (const C* curve : curves) {
        json.beginObject().member("name", std::string_view(curve->name));
        if (isIncomplete(*curve))
            json.member("incomplete", true);
        else
            reportCurve(json, *curve);
        json.endObject();
    }
    json.endList();
    WorkBudget budget(limits::kSteps);
    if constexpr (C::kCapabilities.relations)
        return reportTogether(json, std::span<const C* const>(curves), budget);
    return {};
}

bool isReported(SheetIndex sheet, std::optional<SheetIndex> only) {
    return !only || *only == sheet;
}

std::optional<FileError> outputLimitError(const Document& document, std::optional<SheetIndex> only, Output output) {
    for (SheetIndex index = 0; index < kSheetCount; ++index)
        if (isReported(index, only))
            if (std::optional<FileError> error = outputLimitError(document.sheets[index], index, output))
                return error;
    return {};
}

} // namespace

std::variant<std::string, FileError> reportJson(const Document& document, std::string_view file,
                                                std::optional<SheetIndex> only) {
    if (std::optional<FileError> error = reportJsonLimitError(document, only))
        return *std::move(error);
    JsonWriter json(JsonWriter::Digits::seventeen);
    json.beginObject().member("format", "kriva-report").member("version", kReportVersion).member("document", file);
    json.key("sheets").beginObject();
    for (SheetIndex index = 0; index < kSheetCount; ++index) {
        if (!isReported(index, only))
            continue;
        json.key(sheetName(index)).beginObject();
        std::optional<FileError> error = std::visit(
            [&]<class C>(const C&) { return reportSheetOf<C>(json, document.sheets[index]); }, emptyCurve(index));
        if (error)
            return *std::move(error);
        json.endObject();
    }
    json.endObject().endObject();
    return std::move(json).take();
}

std::optional<FileError> reportLimitError(const Document& document, std::optional<SheetIndex> only) {
    return outputLimitError(document, only, Output::report);
}

std::optional<FileError> reportJsonLimitError(const Document& document, std::optional<SheetIndex> only) {
    if (std::optional<FileError> error = reportLimitError(document, only))
        return error;
    return outputLimitError(document, only, Output::reportJson);
}

} // namespace kriva
