#include "core/sheets/spline/spline_crossings.h"

#include "core/curve/json/json_writer.h"
#include "core/figure/labels.h"

#include <algorithm>

namespace kriva {
namespace {

/// More places are counted, but not listed one by one.
constexpr std::size_t kMostListed = 1000;

void writePlace(JsonWriter& json, const Crossing& place) {
    json.beginObject().member("at", place.at).key("passes").beginList();
    for (const Pass& pass : place.passes)
        json.beginObject()
            .member("curve", static_cast<int>(pass.curve))
            .member("segment", static_cast<int>(pass.segment))
            .member("t", pass.t)
            .endObject();
    json.endList().endObject();
}

void writeOverlap(JsonWriter& json, const Overlap& overlap) {
    json.beginObject().key("passes").beginList();
    for (const PassedPart& part : overlap.passes)
        json.beginObject()
            .member("curve", static_cast<int>(part.curve))
            .member("segment", static_cast<int>(part.segment))
            .member("from", part.from)
            .member("to", part.to)
            .endObject();
    json.endList().endObject();
}

Layer crossingsLayer(std::span<const SplineCurve* const> curves, const Crossings& crossings) {
    const auto isShown = [&](const auto& pass) { return curves[pass.curve]->view.isShown; };
    Points places;
    for (const Crossing& place : crossings.places)
        if (std::ranges::count_if(place.passes, isShown) >= 2)
            places.push_back(place.at);
    return {"crossings", {}, {{std::move(places), Role::crossing}}};
}

/// Why there are no crossings to tell.
FileError refusalFor(WorkEnd end) {
    FileError error;
    error.place = std::string("sheets.").append(SplineCurve::kSheet).append(".curves");
    error.problem = end == WorkEnd::tooMuchFound ? FileProblem::tooManyPasses : FileProblem::tooManyIntersections;
    if (end == WorkEnd::tooMuchFound)
        error.numbers = {static_cast<double>(limits::kPasses)};
    return error;
}

PassedPlace passedPlace(const Crossing& crossing, bool isOfSeveral) {
    PassedPlace place{crossing.at, {}};
    for (const Pass& pass : crossing.passes)
        place.passes.push_back({isOfSeveral ? std::optional(static_cast<int>(pass.curve)) : std::nullopt,
                                static_cast<int>(pass.segment), pass.t});
    return place;
}

} // namespace

std::optional<Crossings> crossingsOf(std::span<const SplineCurve* const> curves, WorkBudget& budget,
                                     std::size_t mostPasses) {
    std::vector<SplineChain> chains;
    for (const SplineCurve* curve : curves)
        chains.push_back(solveSpline(*curve));
    std::vector<SegmentChain> parts;
    for (std::size_t i = 0; i < curves.size(); ++i)
        parts.push_back({chains[i].segments, curves[i]->closed});
    return findCrossings(parts, budget, mostPasses);
}

std::optional<FileError> reportTogether(JsonWriter& json, std::span<const SplineCurve* const> curves,
                                        WorkBudget& budget) {
    const std::optional<Crossings> crossings = crossingsOf(curves, budget);
    if (!crossings)
        return refusalFor(*budget.end());
    json.key("crossings").beginList();
    for (const Crossing& place : crossings->places)
        writePlace(json, place);
    json.endList().key("overlaps").beginList();
    for (const Overlap& overlap : crossings->overlaps)
        writeOverlap(json, overlap);
    json.endList();
    return {};
}

Relations refusedRelations(WorkEnd end) {
    Relations relations;
    if (end == WorkEnd::tooMuchFound)
        relations.results.push_back({translatable("Caption", "Passes through crossings and overlaps"), "",
                                     MoreThan{static_cast<int>(limits::kPasses)}});
    else
        relations.results.push_back({Caption::crossingCount, "", Caption::tooManyToCount});
    relations.refusal = refusalFor(end);
    return relations;
}

std::optional<Relations> relationsOf(std::span<const SplineCurve* const> curves, WorkBudget& budget) {
    if (std::ranges::all_of(curves, [](const SplineCurve* curve) { return isIncomplete(*curve); }))
        return Relations();
    const std::optional<Crossings> found = crossingsOf(curves, budget);
    if (budget.end() == WorkEnd::stopped)
        return {};
    if (!found)
        return refusedRelations(*budget.end());
    const Crossings& crossings = *found;
    Relations relations;
    relations.results.push_back({Caption::crossingCount, "", static_cast<int>(crossings.places.size())});
    for (std::size_t i = 0; i < std::min(crossings.places.size(), kMostListed); ++i)
        relations.results.push_back(
            {Caption::crossing, decimal(static_cast<int>(i)), passedPlace(crossings.places[i], curves.size() > 1)});
    relations.results.push_back(
        {translatable("Caption", "Overlaps of the sheet"), "", static_cast<int>(crossings.overlaps.size())});
    relations.figure.layers.push_back(crossingsLayer(curves, crossings));
    return relations;
}

} // namespace kriva
