#include "ui/sheets/results/curve_results.h"

namespace kriva::ui {
namespace {

/// None without a curve; that it is incomplete is one as well.
std::optional<std::vector<Result>> resultsOf(const std::optional<Curve>& curve, WorkBudget& budget) {
    if (!curve)
        return std::vector<Result>();
    if (isIncomplete(*curve))
        return std::vector<Result>{{Caption::incomplete, {}, std::string()}};
    return results(*curve, budget);
}

} // namespace

CurveResults::CurveResults(ShownSheet& sheet, QObject* parent)
    : QObject(parent)
    , work_(sheet, [this](const std::optional<Curve>& curve, WorkBudget& budget) -> CoalescingWorker::Take {
        return [this, results = resultsOf(curve, budget)] { take(results.value_or(std::vector<Result>())); };
    }) {}

void CurveResults::take(std::vector<Result> results) {
    results_ = std::move(results);
    Q_EMIT changed();
}

} // namespace kriva::ui
