#pragma once

#include "core/curve/sheet.h"
#include "core/sheets/combined/combined_curve.h"
#include "core/sheets/combined/combined_run.h"

/// The sheet `combined`: what the combined algorithm makes of a curve, its edits and what comes out of it.
namespace kriva {

namespace limits {
/// Of points in the interpolated runs of the sheet, where it is reported or drawn into a file: one takes some 4
/// microseconds.
inline constexpr std::size_t kInterpolatedPairs = 1'000'000;
/// Of the paths, in the same: one takes some 15 microseconds.
inline constexpr std::size_t kPathPieces = 200'000;
} // namespace limits

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

/// How many stages the algorithm has: the given points, their runs, the runs' polynomials, what joins them, the whole.
inline constexpr int kCombinedStages = 5;

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

// What every sheet has, see sheet.h. Corrections follow their pairs; those of pairs that an edit takes apart are
// dropped.

[[nodiscard]] inline std::size_t pointCount(const CombinedCurve& curve) {
    return curve.points.size();
}
[[nodiscard]] inline Point pointAt(const CombinedCurve& curve, int index) {
    return curve.points[static_cast<std::size_t>(index)];
}
[[nodiscard]] inline std::size_t derivedPointCount(const CombinedCurve&) {
    return 0;
}
/// "tooManyPointsInRun" where a run of an interpolation is too long, at the longest one.
[[nodiscard]] std::optional<FileError> pointLimitError(const CombinedCurve& curve);
/// Those of corrections too.
[[nodiscard]] bool isWithin(const CombinedCurve& curve, double limit);
[[nodiscard]] inline std::optional<int> polynomialDegree(const CombinedCurve&) {
    return {};
}
/// The points, then under Method::pairs the middle points of pairs; of a pair of two quadratics, the point where these
/// meet.
[[nodiscard]] std::vector<Grip> grips(const CombinedCurve& curve);
/// The same where combine() has given its answer, empty while the curve is incomplete.
[[nodiscard]] std::vector<Grip> grips(const CombinedCurve& curve, const Combined& combined);
[[nodiscard]] inline std::string_view layerOf(const CombinedCurve&, GripKind kind) {
    return kind == GripKind::middle ? "middle-points" : "points";
}

/// A middle point that is moved becomes a correction; those of moved points stay where they are.
[[nodiscard]] CombinedCurve withGripsMoved(const CombinedCurve& curve, std::span<const GripId> ids, Vector by);
[[nodiscard]] Edited<CombinedCurve> withPointAdded(CombinedCurve curve, Point at);
[[nodiscard]] CombinedCurve withPointsAdded(CombinedCurve curve, std::span<const Point> points);
[[nodiscard]] CombinedCurve appended(CombinedCurve curve, const CombinedCurve& other);
/// One more given point where the path is nearest to `near`; nothing below two points. Interpolations keep their shape;
/// other polynomials are fitted anew and change a little.
[[nodiscard]] std::optional<Edited<CombinedCurve>> withPointInserted(const CombinedCurve& curve, Point near);
/// The same in the middle of the path behind a point, before the last one where that is named, or where two neighbours
/// are farthest apart where none is.
[[nodiscard]] std::optional<Edited<CombinedCurve>> withPointInsertedBehind(const CombinedCurve& curve,
                                                                           std::optional<int> point);
/// Under Method::pairs, the pair nearest to `from` pulled there by its middle point, which becomes a correction;
/// nothing where another piece is nearer, or under another method.
[[nodiscard]] std::optional<CombinedCurve> withCurvePulled(const CombinedCurve& curve, Point from, Vector by);
[[nodiscard]] Edited<CombinedCurve> withPointsRemoved(const CombinedCurve& curve, const std::vector<int>& indices);
/// The same points. Runs keep their turning points in the new order, so the curve may change.
[[nodiscard]] Edited<CombinedCurve> reversed(const CombinedCurve& curve);
/// After a step of the algorithm, which only hides layers; nothing elsewhere.
[[nodiscard]] std::optional<Frame<CombinedCurve>> atFrame(const CombinedCurve& curve, const FramePlace& place);

[[nodiscard]] std::span<const LayerInfo> layersOf(const CombinedCurve& curve);
/// Pieces beyond the range of doubles are left out.
[[nodiscard]] Figure figureOf(const CombinedCurve& curve, const FigureContext& context);
[[nodiscard]] std::optional<DrawnCurve> drawn(const CombinedCurve& curve, const FigureContext& context,
                                              WorkBudget& budget);
[[nodiscard]] std::uint64_t drawingSteps(const CombinedCurve& curve);
[[nodiscard]] std::optional<std::vector<Result>> results(const CombinedCurve& curve, WorkBudget& budget);
/// y(x) of the runs and their slopes y'(x), under interpolation above those under approximation. Interpolation through
/// 201 points takes some 0.1 s.
[[nodiscard]] std::optional<std::vector<PlotGroup>> plotsOf(const CombinedCurve& curve, WorkBudget& budget);
/// The runs with their polynomials in the chosen basis and their residuals; the joins with their control points.
[[nodiscard]] std::optional<std::vector<Table>> tablesOf(const CombinedCurve& curve, WorkBudget& budget);
void reportCurve(JsonWriter& json, const CombinedCurve& curve);
void readCurve(const JsonNode& node, CombinedCurve& curve);
void writeCurve(JsonWriter& json, const CombinedCurve& curve);
/// Where solving all curves would take too long, whatever is made of them.
[[nodiscard]] std::optional<FileError> outputLimitError(std::span<const CombinedCurve* const> curves, Output output);

// What this one has besides.

/// A new point before the point `index`; at the end where there is no such point.
[[nodiscard]] Edited<CombinedCurve> withPointInserted(const CombinedCurve& curve, int index, Point at);
/// The pair that starts at the point `pair` with this middle point, or with nothing with its own.
[[nodiscard]] CombinedCurve withCorrection(const CombinedCurve& curve, int pair, std::optional<Point> middle);
/// The pair that starts at the point `pair` as the quadratic that passes through a place at its parameter t, strictly
/// between 0 and 1.
[[nodiscard]] CombinedCurve withPairThrough(const CombinedCurve& curve, int pair, double t, Point place);

/// The word of a basis in documents and reports: "chebyshev".
[[nodiscard]] std::string_view nameOf(CombinedCurve::Basis basis);

} // namespace kriva
