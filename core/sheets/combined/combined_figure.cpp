#include "core/bezier/evaluate.h"
#include "core/bezier/measures/curvature.h"
#include "core/figure/labels.h"
#include "core/sheets/combined/combined.h"

#include <array>

namespace kriva {
namespace {

/// The algorithm's stages: the given points, their runs, the runs' polynomials, what joins them, the whole.
enum Stage { kGiven, kRuns, kPolynomials, kJoins, kWhole };

constexpr std::array kLayers{
    LayerInfo{"given-polygon", translatable("Caption", "Polygon of the given points")},
    LayerInfo{"run-polygons", translatable("Caption", "Polygons of runs"), false, true, kRuns},
    LayerInfo{"polynomials", translatable("Caption", "Polynomials of runs"), false, true, kPolynomials},
    LayerInfo{kCurveLayer, Caption::curve, true, false, kWhole},
    LayerInfo{"runs", Caption::runs, true, true, kJoins},
    LayerInfo{"joins", Caption::joins, true, true, kJoins},
    LayerInfo{"middle-points", translatable("Caption", "Middle points of pairs"), true, true, kJoins},
    LayerInfo{"points", Caption::points},
    LayerInfo{"run-numbers", translatable("Caption", "Numbers of runs"), true, true, kRuns},
    LayerInfo{"labels", Caption::labels, true, true},
};

/// Adjoining curves gathered into paths; one that leaves the range of doubles is left out and ends its path.
class PathBuilder {
  public:
    void add(const Points& curve) {
        if (!std::isfinite(polygonLength(curve)))
            finish();
        else
            curves_.push_back(curve);
    }
    [[nodiscard]] std::vector<Path> take() && {
        finish();
        return std::move(paths_);
    }

  private:
    void finish() {
        if (!curves_.empty())
            paths_.push_back(chain(curves_, false));
        curves_.clear();
    }

    std::vector<Points> curves_;
    std::vector<Path> paths_;
};

/// A run's polynomial goes in as its parts, whose control points draw it without loss.
void addPiece(const Combined& combined, const PathPiece& piece, PathBuilder& builder) {
    if (piece.kind != PathPiece::Kind::run) {
        builder.add(piece.curve.points);
        return;
    }
    for (const Points& part : combined.runs[static_cast<std::size_t>(piece.index)].parts)
        builder.add(part);
}

Layer curveLayer(const CombinedCurve& curve, const Combined& combined, int index) {
    PathBuilder builder;
    for (const PathPiece& piece : combined.path)
        addPiece(combined, piece, builder);
    Layer layer{kCurveLayer};
    for (Path& path : std::move(builder).take())
        layer.strokes.push_back({std::move(path), Role::curve, 0, 1, curve.style, index});
    return layer;
}

Layer runPolygonsLayer(const CombinedCurve& curve, const Combined& combined) {
    Layer layer{"run-polygons"};
    for (std::size_t i = 0; i < combined.runs.size(); ++i)
        layer.strokes.push_back(
            {polyline(pointsOf(combined.runs[i].points, curve.points)), Role::runPolygon, static_cast<int>(i)});
    return layer;
}

/// Each run's y(x), also where pairs go another way from point to point.
Layer polynomialsLayer(const Combined& combined) {
    Layer layer{"polynomials"};
    for (std::size_t i = 0; i < combined.runs.size(); ++i) {
        PathBuilder builder;
        for (const Points& part : combined.runs[i].parts)
            builder.add(part);
        for (Path& path : std::move(builder).take())
            layer.strokes.push_back({std::move(path), Role::fit, static_cast<int>(i)});
    }
    return layer;
}

/// The pieces of each run; the pairs of one follow each other in the path.
Layer runsLayer(const Combined& combined) {
    Layer layer{"runs"};
    auto piece = combined.path.begin();
    for (std::size_t i = 0; i < combined.runs.size(); ++i) {
        PathBuilder builder;
        const int last = combined.runs[i].points.last;
        const auto isOfRun = [&](const PathPiece& p) {
            return p.kind == PathPiece::Kind::pair ? p.index < last
                                                   : p.kind == PathPiece::Kind::run && p.index == static_cast<int>(i);
        };
        for (; piece != combined.path.end() && (piece->kind == PathPiece::Kind::join || isOfRun(*piece)); ++piece)
            if (piece->kind != PathPiece::Kind::join)
                addPiece(combined, *piece, builder);
        for (Path& path : std::move(builder).take())
            layer.strokes.push_back({std::move(path), Role::run, static_cast<int>(i)});
    }
    return layer;
}

Layer joinsLayer(const Combined& combined) {
    Layer layer{"joins"};
    for (const CombinedJoin& join : combined.joins)
        if (std::isfinite(polygonLength(join.points)))
            layer.strokes.push_back({singleCurve(join.points), Role::join});
    return layer;
}

/// The middle points of pairs, and a polygon along them for each row of pairs.
Layer middleLayer(const CombinedCurve& curve, const Combined& combined) {
    Layer layer{"middle-points"};
    Marks marks{{}, Role::handle};
    Points polygon;
    const auto finish = [&] {
        if (!polygon.empty())
            layer.strokes.push_back({polyline(polygon), Role::handle});
        polygon.clear();
    };
    int next = 0;
    for (const PairMiddle& middle : pairMiddles(combined)) {
        if (middle.pair != next || !isFinite(middle.at))
            finish();
        if (!isFinite(middle.at))
            continue;
        const auto first = static_cast<std::size_t>(middle.pair);
        if (polygon.empty())
            polygon.push_back(curve.points[first]);
        polygon.insert(polygon.end(), {middle.at, curve.points[first + 1]});
        marks.at.push_back(middle.at);
        next = middle.pair + 1;
    }
    finish();
    layer.marks.push_back(std::move(marks));
    return layer;
}

/// Where the number of a run stands: in the middle of its points, on its polynomial if that is its path.
Point middleOf(const CombinedCurve& curve, const CombinedRun& run) {
    if (curve.method == CombinedCurve::Method::pairs || run.parts.empty())
        return curve.points[static_cast<std::size_t>(run.points.first + run.points.last) / 2];
    return run.parts.size() == 1 ? evaluate(run.parts.front(), 0.5) : run.parts[run.parts.size() / 2].front();
}

Layer runNumbers(const CombinedCurve& curve, const Combined& combined) {
    Layer layer{"run-numbers"};
    for (std::size_t i = 0; i < combined.runs.size(); ++i) {
        Label label{middleOf(curve, combined.runs[i]), Caption::none, decimal(static_cast<int>(i)), ""};
        label.side = LabelSide::belowRight;
        if (isFinite(label.at))
            layer.labels.push_back(std::move(label));
    }
    return layer;
}

Figure figureOf(const CombinedCurve& curve, const Combined& combined, const FigureContext& context) {
    Figure figure;
    figure.layers.push_back({"given-polygon", {{polyline(curve.points), Role::controlPolygon}}});
    if (isDrawn("run-polygons", kLayers, context))
        figure.layers.push_back(runPolygonsLayer(curve, combined));
    if (isDrawn("polynomials", kLayers, context))
        figure.layers.push_back(polynomialsLayer(combined));
    figure.layers.push_back(curveLayer(curve, combined, context.curve));
    if (context.isActive) {
        figure.layers.push_back(runsLayer(combined));
        figure.layers.push_back(joinsLayer(combined));
        figure.layers.push_back(middleLayer(curve, combined));
    }
    figure.layers.push_back({"points", {}, {{curve.points, Role::point}}});
    if (context.isActive)
        figure.layers.push_back(runNumbers(curve, combined));
    if (curve.points.size() <= kMostLabelledPoints)
        figure.layers.push_back({"labels", {}, {}, indexedLabels("p", curve.points)});
    return figure;
}

} // namespace

std::span<const LayerInfo> layersOf(const CombinedCurve&) {
    return kLayers;
}

Figure figureOf(const CombinedCurve& curve, const FigureContext& context) {
    return figureOf(curve, isIncomplete(curve) ? Combined{} : combine(curve), context);
}

std::optional<DrawnCurve> drawn(const CombinedCurve& curve, const FigureContext& context, WorkBudget& budget) {
    const std::optional<Combined> combined = isIncomplete(curve) ? Combined{} : combine(curve, budget);
    if (!combined)
        return {};
    return DrawnCurve{figureOf(curve, *combined, context), grips(curve, *combined)};
}

std::uint64_t drawingSteps(const CombinedCurve& curve) {
    constexpr std::uint64_t kPiece = 300;
    constexpr std::uint64_t kPair = 160; // of points of an interpolation
    const auto coefficients = static_cast<std::uint64_t>(curve.degree) + 1;
    return kPiece * pathPieces(curve) + kPair * interpolatedPairs(curve) +
           coefficients * coefficients * curve.points.size();
}

} // namespace kriva
