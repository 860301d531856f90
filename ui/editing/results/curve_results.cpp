#include "ui/editing/results/curve_results.h"

#include "ui/editing/sheet/shown_sheet.h"

#include <QThreadPool>

#include <utility>

namespace kriva::ui {
namespace {

/// So many that the window has no time to give their memory back.
constexpr std::size_t kManyRows = 10'000;

/// None without a curve; that it is incomplete is one as well.
std::optional<std::vector<Result>> resultsOf(const Curve* curve, WorkBudget& budget) {
    if (!curve)
        return std::vector<Result>();
    if (isIncomplete(*curve))
        return std::vector<Result>{{Caption::incomplete, {}, std::string()}};
    return results(*curve, budget);
}

} // namespace

CurveResults::CurveResults(ShownSheet& sheet, QObject* parent)
    : QObject(parent)
    , work_(sheet, [this, &sheet](const Curve* curve, WorkBudget& budget) -> CoalescingWorker::Take {
        auto found = resultsOf(curve, budget).value_or(std::vector<Result>());
        return [this, &sheet, results = std::make_shared<const std::vector<Result>>(std::move(found))] {
            auto before = std::exchange(results_, results);
            Q_EMIT changed();
            if (before->size() > kManyRows)
                sheet.workers().start([before = std::move(before)]() mutable { before.reset(); });
        };
    }) {}

} // namespace kriva::ui
