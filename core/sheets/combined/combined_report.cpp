#include "core/curve/json/json_writer.h"
#include "core/figure/labels.h"
#include "core/sheets/combined/combined.h"
#include "core/sheets/combined/path_measures.h"

namespace kriva {
namespace {

void reportRun(JsonWriter& json, const CombinedRun& run, CombinedCurve::Basis basis) {
    json.beginObject()
        .member("first", run.points.first)
        .member("last", run.points.last)
        .member("direction", run.points.direction)
        .member("degree", run.degree)
        .member("basis", nameOf(basis))
        .member("nodes", run.nodes)
        .member("coefficients", run.coefficients)
        .member("rms", run.rms)
        .member("maxError", run.maxError)
        .member("start", run.start.point())
        .member("end", run.end.point())
        .member("startSlope", run.startSlope)
        .member("endSlope", run.endSlope)
        .endObject();
}

void reportJoin(JsonWriter& json, const CombinedJoin& join) {
    json.beginObject()
        .member("afterRun", join.afterRun)
        .member("kind", join.isQuadratic ? "quadratic" : "cubic")
        .member("points", join.points)
        .endObject();
}

} // namespace

std::optional<FileError> outputLimitError(std::span<const CombinedCurve* const> curves, Output) {
    std::size_t pairs = 0;
    std::size_t pieces = 0;
    for (const CombinedCurve* curve : curves) {
        pairs += interpolatedPairs(*curve);
        pieces += pathPieces(*curve);
    }
    if (pairs > limits::kInterpolatedPairs)
        return errorOfFile(FileProblem::tooManyPairs, {static_cast<double>(limits::kInterpolatedPairs)});
    if (pieces > limits::kPathPieces)
        return errorOfFile(FileProblem::tooManyPathPieces,
                           {static_cast<double>(limits::kPathPieces), static_cast<double>(pieces)});
    return {};
}

void reportCurve(JsonWriter& json, const CombinedCurve& curve) {
    const Combined combined = combine(curve);
    const PathMeasures measures = measure(combined, curve.points);
    json.member("length", measures.length).member("bounds", measures.bounds).key("runs").beginList();
    for (const CombinedRun& run : combined.runs)
        reportRun(json, run, curve.basis);
    json.endList().key("joins").beginList();
    for (const CombinedJoin& join : combined.joins)
        reportJoin(json, join);
    json.endList().key("path").beginList();
    for (const PathPiece& piece : combined.path)
        json.value(piece.curve.points);
    json.endList()
        .member("largestKink", measures.largestKink)
        .member("bendingEnergy", measures.bendingEnergy)
        .member("slopeVariation", measures.slopeVariation);
}

std::optional<std::vector<Result>> results(const CombinedCurve& curve, WorkBudget& budget) {
    const std::optional<Combined> combined = combine(curve, budget);
    const std::optional<PathMeasures> found = combined ? measure(*combined, curve.points, budget) : std::nullopt;
    if (!found)
        return {};
    const PathMeasures& measures = *found;
    std::vector<Result> rows{{Caption::length, "", measures.length},
                             {Caption::bounds, "", measures.bounds},
                             {Caption::largestKink, "", measures.largestKink},
                             {Caption::bendingEnergy, "", measures.bendingEnergy},
                             {Caption::slopeVariation, "", measures.slopeVariation}};
    for (std::size_t i = 0; i < combined->runs.size(); ++i) {
        const CombinedRun& run = combined->runs[i];
        const std::string index = decimal(static_cast<int>(i));
        rows.push_back({translatable("Caption", "Points of run"), index,
                        decimal(run.points.first) + "–" + decimal(run.points.last)});
        rows.push_back({translatable("Caption", "Degree of run"), index, run.degree});
        rows.push_back({Caption::runCoefficients, index, run.coefficients});
        rows.push_back({translatable("Caption", "Residual (root mean square) of run"), index, run.rms});
        rows.push_back({Caption::maxError, index, run.maxError});
    }
    return rows;
}

} // namespace kriva
