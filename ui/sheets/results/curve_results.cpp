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
        auto found = resultsOf(curve, budget).value_or(std::vector<Result>());
        return [this, results = std::make_shared<const std::vector<Result>>(std::move(found))] {
            results_ = results;
            Q_EMIT changed();
        };
    }) {}

} // namespace kriva::ui
