#include "ui/sheets/results/curve_results.h"

namespace kriva::ui {
namespace {

/// None without a curve; that it is incomplete is one as well.
std::vector<Result> resultsOf(const std::optional<Curve>& curve) {
    if (!curve)
        return {};
    if (isIncomplete(*curve))
        return {{Caption::incomplete, {}, std::string()}};
    return results(*curve);
}

} // namespace

CurveResults::CurveResults(ShownSheet& sheet, QObject* parent)
    : QObject(parent)
    , work_(sheet, [this](const std::optional<Curve>& curve, WorkBudget&) -> CoalescingWorker::Take {
        return [this, results = resultsOf(curve)] { take(results); };
    }) {}

void CurveResults::take(std::vector<Result> results) {
    results_ = std::move(results);
    Q_EMIT changed();
}

} // namespace kriva::ui
