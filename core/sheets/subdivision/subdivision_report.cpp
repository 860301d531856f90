#include "core/bezier/bounds.h"
#include "core/bezier/measures/arc_length.h"
#include "core/curve/json/json_writer.h"
#include "core/sheets/subdivision/subdivision.h"

#include <numeric>

namespace kriva {
namespace {

int degreeOf(const Subdivision& subdivision) {
    return static_cast<int>(subdivision.polygon.size()) - 1;
}

Point pointAtT(const Subdivision& subdivision) {
    return subdivision.triangle.back().front();
}

} // namespace

std::size_t reportedSchemePoints(const SubdivisionCurve& curve) {
    if (isIncomplete(curve))
        return 0;
    const auto points = static_cast<std::size_t>(std::reduce(curve.multiplicity.begin(), curve.multiplicity.end()));
    return points * (points + 1) / 2;
}

std::optional<FileError> outputLimitError(std::span<const SubdivisionCurve* const> curves, Output output) {
    std::size_t points = 0;
    for (const SubdivisionCurve* curve : curves)
        points += reportedSchemePoints(*curve);
    if (output != Output::reportJson || points <= limits::kReportedSchemePoints)
        return {};
    return errorOfFile(FileProblem::tooManySchemePoints,
                       {static_cast<double>(limits::kReportedSchemePoints), static_cast<double>(points)});
}

void reportCurve(JsonWriter& json, const SubdivisionCurve& curve) {
    const Subdivision subdivision = subdivide(curve);
    json.member("degree", degreeOf(subdivision))
        .member("length", arcLength(subdivision.polygon))
        .member("bounds", tightBounds(subdivision.polygon))
        .member("point", pointAtT(subdivision))
        .member("derivative", subdivision.derivative)
        .member("triangle", subdivision.triangle)
        .member("left", subdivision.halves.left)
        .member("right", subdivision.halves.right)
        .member("pieces", pieces(curve));
    if (subdivision.blossom)
        json.member("blossom", *subdivision.blossom);
}

std::optional<std::vector<Result>> results(const SubdivisionCurve& curve, WorkBudget& budget) {
    const Subdivision subdivision = subdivide(curve);
    if (!budget.spend())
        return {};
    std::vector<Result> rows{{Caption::degree, "", degreeOf(subdivision)},
                             {Caption::length, "", arcLength(subdivision.polygon)},
                             {Caption::bounds, "", tightBounds(subdivision.polygon)},
                             {Caption::pointAtT, "", pointAtT(subdivision)},
                             {translatable("Caption", "Derivative at t"), "", subdivision.derivative},
                             {Caption::leftPolygon, "", subdivision.halves.left},
                             {Caption::rightPolygon, "", subdivision.halves.right},
                             {translatable("Caption", "Number of pieces"), "", 1 << curve.levels}};
    if (subdivision.blossom)
        rows.push_back({Caption::blossom, "", *subdivision.blossom});
    return rows;
}

} // namespace kriva
