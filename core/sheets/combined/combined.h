#pragma once

#include "core/budget/work_budget.h"
#include "core/sheets/combined/combined_curve.h"
#include "core/sheets/combined/combined_run.h"

namespace kriva {

struct CombinedJoin {
    int afterRun = 0;
    bool isQuadratic = false; ///< otherwise cubic
    Points points;
};

/// One Bézier curve of the path.
struct PathPiece {
    enum class Kind { run, pair, join };
    Kind kind = Kind::run;
    int index = 0; ///< of the run, of the pair's first point, or of the join
    TangentPiece curve;
};

struct Combined {
    std::vector<CombinedRun> runs;
    std::vector<CombinedJoin> joins;
    std::vector<PathPiece> path; ///< in drawing order
};

/// The curve must be complete. Linear in the points, with 201 of them in one run under interpolation some 0.1 s.
[[nodiscard]] std::optional<Combined> combine(const CombinedCurve& curve, WorkBudget& budget);
[[nodiscard]] Combined combine(const CombinedCurve& curve);

/// The sum over the runs under interpolation of the squares of their points: what makes interpolating long. Linear.
[[nodiscard]] std::size_t interpolatedPairs(const CombinedCurve& curve);
/// About how many pieces the path has: runs or the pairs in them, and as many joins as there can be. Linear.
[[nodiscard]] std::size_t pathPieces(const CombinedCurve& curve);

/// What a pair is bent by: the middle point of its quadratic, or the point where its two quadratics meet.
struct PairMiddle {
    int pair = 0; ///< its first point
    Point at;
};

/// Those of all pairs, in drawing order; empty but under Method::pairs.
[[nodiscard]] std::vector<PairMiddle> pairMiddles(const Combined& combined);

} // namespace kriva
