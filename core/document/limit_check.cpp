#include "core/document/limit_check.h"

#include "core/document/limits.h"

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

std::optional<FileError> errorOf(const Totals& totals, SheetIndex index) {
    if (totals.curves > limits::kCurvesInSheet)
        return tooManyCurves(index, limits::kCurvesInSheet);
    if (totals.points > limits::kPointsInSheet)
        return tooManyCurves(index, limits::kPointsInSheet);
    if (totals.derivedPoints > limits::kDerivedPointsInSheet)
        return tooManyCurves(index, limits::kDerivedPointsInSheet);
    return {};
}

} // namespace

FileError tooManyCurves(SheetIndex sheet, std::size_t limit) {
    FileError error;
    error.problem = FileProblem::tooMany;
    error.place = std::string("sheets.").append(sheetName(sheet)).append(".curves");
    error.numbers = {static_cast<double>(limit)};
    return error;
}

std::optional<FileError> sheetLimitError(const Sheet& sheet, SheetIndex index) {
    Totals totals;
    for (const Curve& curve : sheet.curves)
        totals.add(curve);
    return errorOf(totals, index);
}

std::optional<FileError> interpolationLimitError(const Sheet& sheet, SheetIndex index) {
    std::size_t pairs = 0;
    for (const Curve& curve : sheet.curves)
        pairs += std::visit(
            [](const auto& c) -> std::size_t {
                if constexpr (requires { interpolatedPairs(c); })
                    return interpolatedPairs(c);
                else
                    return 0;
            },
            curve);
    if (pairs <= limits::kInterpolatedPairs)
        return {};
    FileError error = tooManyCurves(index, limits::kInterpolatedPairs);
    error.problem = FileProblem::tooManyPairs;
    return error;
}

std::optional<FileError> limitErrorWith(const Sheet& sheet, SheetIndex index, std::optional<std::size_t> replaced,
                                        const Curve& curve) {
    if (pointCount(curve) > mostPoints(curve))
        return tooManyCurves(index, mostPoints(curve));
    if (!isWithin(curve, limits::kNumber)) {
        FileError error = tooManyCurves(index, 0);
        error.problem = FileProblem::numberOutOfRange;
        error.numbers = {-limits::kNumber, limits::kNumber};
        return error;
    }
    Totals totals;
    for (std::size_t i = 0; i < sheet.curves.size(); ++i)
        if (i != replaced)
            totals.add(sheet.curves[i]);
    totals.add(curve);
    return errorOf(totals, index);
}

} // namespace kriva
