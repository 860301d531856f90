#include "core/sheets/combined/combined.h"

#include "core/bezier/measures/curvature.h"
#include "core/geometry/box.h"

#include <cassert>

namespace kriva {
namespace {

/// The pieces of a run between its neighbouring points.
void addPairs(const CombinedCurve& curve, const CombinedRun& run, std::vector<PathPiece>& path) {
    for (int i = run.points.first; i < run.points.last; ++i) {
        const auto at = static_cast<std::size_t>(i - run.points.first);
        const CurveEnd& from = run.pairEnds[at];
        const CurveEnd& to = run.pairEnds[at + 1];
        if (const auto correction = curve.corrections.find(i); correction != curve.corrections.end()) {
            const Points points{from.point(), correction->second, to.point()};
            path.push_back({PathPiece::Kind::pair, i, {points, *startTangent(points), *endTangent(points), points}});
            continue;
        }
        for (TangentPiece& piece : pairOf(from, to))
            path.push_back({PathPiece::Kind::pair, i, std::move(piece)});
    }
}

void addRun(const CombinedCurve& curve, const CombinedRun& run, int index, std::vector<PathPiece>& path) {
    if (curve.method == CombinedCurve::Method::pairs)
        addPairs(curve, run, path);
    else if (run.points.direction != 0)
        path.push_back(
            {PathPiece::Kind::run, index, {run.graph, run.start.tangent->vector(), run.end.tangent->vector(), {}}});
}

} // namespace

std::optional<Combined> combine(const CombinedCurve& curve, WorkBudget& budget) {
    assert(!isIncomplete(curve));
    constexpr double kMeeting = 1e-12; // of the diagonal: runs whose ends are no farther apart meet
    const double meeting = kMeeting * diagonal(boxOf(curve.points));
    Combined result;
    for (const MonotoneRun& points : monotoneRuns(curve.points)) {
        if (!budget.spend())
            return {};
        CombinedRun run = fitRun(curve, points);
        const int index = static_cast<int>(result.runs.size());
        if (index > 0) {
            const CurveEnd& before = result.runs.back().end;
            if (distance(before.point(), run.start.point()) > meeting) {
                TangentPiece join = joinOf(before, run.start);
                result.joins.push_back({index - 1, join.points.size() == 3, join.points});
                result.path.push_back(
                    {PathPiece::Kind::join, static_cast<int>(result.joins.size()) - 1, std::move(join)});
            }
        }
        addRun(curve, run, index, result.path);
        result.runs.push_back(std::move(run));
    }
    return result;
}

Combined combine(const CombinedCurve& curve) {
    return withoutLimit([&](WorkBudget& budget) { return combine(curve, budget); });
}

std::size_t interpolatedPairs(const CombinedCurve& curve) {
    if (isIncomplete(curve) || curve.method != CombinedCurve::Method::interpolation)
        return 0;
    std::size_t pairs = 0;
    for (const MonotoneRun& run : monotoneRuns(curve.points))
        pairs += run.size() * run.size();
    return pairs;
}

std::size_t pathPieces(const CombinedCurve& curve) {
    if (isIncomplete(curve))
        return 0;
    const std::vector<MonotoneRun> runs = monotoneRuns(curve.points);
    const std::size_t joins = runs.size() - 1;
    const bool isOfPairs = curve.method == CombinedCurve::Method::pairs;
    return joins + (isOfPairs ? curve.points.size() - runs.size() : runs.size());
}

std::vector<PairMiddle> pairMiddles(const Combined& combined) {
    std::vector<PairMiddle> middles;
    for (const PathPiece& piece : combined.path) {
        if (piece.kind != PathPiece::Kind::pair)
            continue;
        const bool isSecond = !middles.empty() && middles.back().pair == piece.index;
        if (isSecond)
            middles.back().at = piece.curve.points.front();
        else
            middles.push_back({piece.index, piece.curve.points[1]});
    }
    return middles;
}

} // namespace kriva
