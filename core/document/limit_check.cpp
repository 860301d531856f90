#include "core/document/limit_check.h"

#include "core/curve/limits.h"

#include <algorithm>
#include <cmath>

namespace kriva {
namespace {

/// What is limited over a whole sheet.
struct Totals {
    std::size_t curves = 0;
    std::size_t points = 0;
    std::size_t derivedPoints = 0;

    void add(const Curve& curve) {
        ++curves;
        points += pointCount(curve);
        derivedPoints += derivedPointCount(curve);
    }
};

std::optional<FileError> errorOf(const Totals& totals) {
    if (std::optional<FileError> error = curveCountError(totals.curves))
        return error;
    if (totals.points > limits::kPointsInSheet)
        return errorOfFile(FileProblem::tooManyPoints, {static_cast<double>(limits::kPointsInSheet)});
    if (totals.derivedPoints > limits::kDerivedPointsInSheet)
        return errorOfFile(FileProblem::tooManyDerivedPoints, {static_cast<double>(limits::kDerivedPointsInSheet)});
    return {};
}

} // namespace

std::optional<FileError> curveCountError(std::size_t curves) {
    if (curves <= limits::kCurvesInSheet)
        return {};
    return errorOfFile(FileProblem::tooManyCurves,
                       {static_cast<double>(limits::kCurvesInSheet), static_cast<double>(curves)});
}

std::optional<FileError> sheetLimitError(const Sheet& sheet) {
    Totals totals;
    for (const Curve& curve : sheet.curves)
        totals.add(curve);
    return errorOf(totals);
}

std::string placeOfCurves(SheetIndex sheet) {
    return std::string("sheets.").append(sheetName(sheet)).append(".curves");
}

std::optional<FileError> outputLimitError(const Sheet& sheet, SheetIndex index, Output output) {
    std::optional<FileError> error = std::visit(
        [&]<class C>(const C&) -> std::optional<FileError> {
            if constexpr (C::kCapabilities.outputLimits)
                return outputLimitError(std::span<const C* const>(curvesOf<C>(sheet)), output);
            else
                return {};
        },
        emptyCurve(index));
    if (error)
        error->place = placeOfCurves(index);
    return error;
}

std::optional<FileError> limitErrorWith(const Sheet& sheet, std::optional<std::size_t> replaced, const Curve& curve) {
    if (std::optional<FileError> error = pointLimitError(curve))
        return error;
    if (!isWithin(curve, limits::kNumber))
        return errorOfFile(FileProblem::coordinatesOutOfRange, {-limits::kNumber, limits::kNumber});
    Totals totals;
    for (std::size_t i = 0; i < sheet.curves.size(); ++i)
        if (i != replaced)
            totals.add(sheet.curves[i]);
    totals.add(curve);
    return errorOf(totals);
}

} // namespace kriva
