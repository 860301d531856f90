#include "core/document/report.h"

#include "core/budget/work_budget.h"
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
    // Only some sheets tell something about all their curves together.
    WorkBudget budget(limits::kSteps);
    if constexpr (requires { reportTogether(json, std::span<const C* const>(curves), budget); })
        return reportTogether(json, std::span<const C* const>(curves), budget);
    return {};
}

bool isReported(SheetIndex sheet, std::optional<SheetIndex> only) {
    return !only || *only == sheet;
}

FileError tooManySegments(SheetIndex sheet, std::size_t segments) {
    FileError error = errorOfFile(FileProblem::tooManySegments,
                                  {static_cast<double>(limits::kReportedSegments), static_cast<double>(segments)});
    error.place = placeOfCurves(sheet);
    return error;
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
    for (SheetIndex index = 0; index < kSheetCount; ++index) {
        std::size_t segments = 0;
        for (const Curve& curve : document.sheets[index].curves)
            segments += std::visit([](const auto& c) { return reportedSegments(c); }, curve);
        if (isReported(index, only) && segments > limits::kReportedSegments)
            return tooManySegments(index, segments);
        if (std::optional<FileError> error = solvingLimitError(document.sheets[index], index);
            error && isReported(index, only))
            return error;
    }
    return {};
}

std::optional<FileError> reportJsonLimitError(const Document& document, std::optional<SheetIndex> only) {
    if (std::optional<FileError> error = reportLimitError(document, only))
        return error;
    for (SheetIndex index = 0; index < kSheetCount; ++index) {
        std::size_t points = 0;
        for (const Curve& curve : document.sheets[index].curves)
            points += std::visit(
                [](const auto& c) -> std::size_t {
                    if constexpr (requires { reportedSchemePoints(c); })
                        return reportedSchemePoints(c);
                    else
                        return 0;
                },
                curve);
        if (!isReported(index, only) || points <= limits::kReportedSchemePoints)
            continue;
        FileError error =
            errorOfFile(FileProblem::tooManySchemePoints,
                        {static_cast<double>(limits::kReportedSchemePoints), static_cast<double>(points)});
        error.place = placeOfCurves(index);
        return error;
    }
    return {};
}

} // namespace kriva
