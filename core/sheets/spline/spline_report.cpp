#include "core/curve/json/json_writer.h"
#include "core/figure/labels.h"
#include "core/sheets/spline/spline.h"
#include "core/sheets/spline/spline_measures.h"

namespace kriva {

std::optional<FileError> outputLimitError(std::span<const SplineCurve* const> curves, Output output) {
    std::size_t segments = 0;
    for (const SplineCurve* curve : curves)
        segments += segmentCount(*curve);
    if (output == Output::figure || segments <= limits::kReportedSegments)
        return {};
    return errorOfFile(FileProblem::tooManySegments,
                       {static_cast<double>(limits::kReportedSegments), static_cast<double>(segments)});
}

void reportCurve(JsonWriter& json, const SplineCurve& curve) {
    const SplineMeasures measures = measure(curve);
    json.member("degree", curve.degree).member("length", measures.length).member("bounds", measures.bounds);
    json.key("segments").beginList();
    for (std::size_t i = 0; i < measures.lengths.size(); ++i)
        json.beginObject()
            .member("points", measures.chain.segments[i])
            .member("length", measures.lengths[i])
            .endObject();
    json.endList().key("knots").beginList();
    for (const Continuity continuity : measures.chain.continuity)
        json.beginObject().member("continuity", nameOf(continuity)).endObject();
    json.endList()
        .member("curvatureExtrema", measures.curvatureExtrema)
        .member("bendingEnergy", measures.bendingEnergy);
}

std::optional<std::vector<Result>> results(const SplineCurve& curve, WorkBudget& budget) {
    const std::optional<SplineMeasures> found = measure(curve, budget);
    if (!found)
        return {};
    const SplineMeasures& measures = *found;
    std::vector<Result> rows{{Caption::degree, "", curve.degree},
                             {Caption::length, "", measures.length},
                             {Caption::bounds, "", measures.bounds},
                             {translatable("Caption", "Extrema of the curvature"), "", measures.curvatureExtrema},
                             {Caption::bendingEnergy, "", measures.bendingEnergy}};
    for (std::size_t i = 0; i < measures.lengths.size(); ++i) {
        const std::string index = decimal(static_cast<int>(i));
        rows.push_back({Caption::segmentLength, index, measures.lengths[i]});
        rows.push_back({Caption::coefficients, index, powerCoefficients(measures.chain.segments[i])});
    }
    for (std::size_t i = 0; i < measures.chain.continuity.size(); ++i) {
        const Continuity continuity = measures.chain.continuity[i];
        const Result::Value value = continuity == Continuity::end ? Result::Value(translatable("Caption", "open end"))
                                                                  : std::string(nameOf(continuity));
        rows.push_back({translatable("Caption", "Continuity at knot"), decimal(static_cast<int>(i)), value});
    }
    return rows;
}

} // namespace kriva
