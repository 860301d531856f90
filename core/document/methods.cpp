#include "core/document/methods.h"

#include "core/curve/limits.h"
#include "core/figure/labels.h"
#include "core/sheets/combined/path_measures.h"
#include "core/sheets/spline/spline_measures.h"

#include <algorithm>
#include <cmath>

namespace kriva {
namespace {

using Method = CombinedCurve::Method;
using Row = std::vector<TableCell>;

constexpr int kLowestDegree = 2;
constexpr int kHighestDegree = 5;

/// Of the distances in y between points and polynomials, over all runs; 0 for curves through the points.
double residual(const Combined& combined) {
    double sum = 0;
    double count = 0;
    for (const CombinedRun& run : combined.runs) {
        const auto size = static_cast<double>(run.points.size());
        sum += size * run.rms * run.rms;
        count += size;
    }
    return std::sqrt(sum / count);
}

bool isWithinLimits(const CombinedCurve& curve) {
    return curve.method != Method::interpolation ||
           std::ranges::all_of(monotoneRuns(curve.points),
                               [](const MonotoneRun& run) { return run.size() <= limits::kControlPoints; });
}

void addMethod(Table& table, Row names, const CombinedCurve& curve, WorkBudget& budget) {
    Row& row = table.rows.emplace_back(std::move(names));
    if (isWithinLimits(curve)) {
        const std::optional<Combined> combined = combine(curve, budget);
        const std::optional<PathMeasures> measures = combined ? measure(*combined, curve.points, budget) : std::nullopt;
        if (!measures)
            return;
        row.push_back({curve.method == Method::approximation ? residual(*combined) : 0.0});
        row.push_back({measures->largestKink});
        row.push_back({measures->slopeVariation});
        row.push_back(measures->bendingEnergy ? TableCell{*measures->bendingEnergy} : TableCell{});
        row.push_back({measures->length});
    }
    row.resize(table.columns.size());
}

/// It runs through all points without a kink, but over no x: its slopes have no variation.
void addSpline(Table& table, const CombinedCurve& curve, WorkBudget& budget) {
    SplineCurve spline;
    spline.rule = SplineCurve::Rule::natural;
    for (const Point p : curve.points)
        spline.knots.push_back({p, SplineKnot::Join::automatic, {}, {}});
    const std::optional<SplineMeasures> measures = measure(spline, budget);
    if (!measures)
        return;
    table.rows.push_back({{SplineCurve::kCaption},
                          {3},
                          {0.0},
                          {0.0},
                          {},
                          measures->bendingEnergy ? TableCell{*measures->bendingEnergy} : TableCell{},
                          {measures->length}});
}

} // namespace

std::optional<Table> compareMethods(const CombinedCurve& curve, WorkBudget& budget) {
    Table table{Caption::methods,
                {{translatable("Caption", "Method")},
                 {Caption::degree},
                 {Caption::residual},
                 {Caption::largestKink},
                 {Caption::slopeVariation},
                 {Caption::bendingEnergy},
                 {Caption::length}},
                {}};
    if (curve.points.size() < 2)
        return table;
    CombinedCurve other = curve;
    other.corrections.clear();
    other.method = Method::interpolation;
    addMethod(table, {{Caption::interpolation}, {}}, other, budget);
    other.method = Method::approximation;
    for (other.degree = kLowestDegree; other.degree <= kHighestDegree; ++other.degree)
        addMethod(table, {{Caption::approximation}, {other.degree}}, other, budget);
    other.method = Method::pairs;
    other.degree = curve.degree;
    addMethod(table, {{translatable("Caption", "Pairs")}, {curve.degree}}, other, budget);
    addSpline(table, curve, budget);
    if (budget.end())
        return {};
    constexpr std::size_t kFirstNumber = 2;
    for (std::size_t column = kFirstNumber; column < table.columns.size(); ++column)
        markLeast(table, column);
    return table;
}

} // namespace kriva
