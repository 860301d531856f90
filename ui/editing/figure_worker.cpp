#include "ui/editing/figure_worker.h"

#include "core/document/sheet_figure.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

#include <memory>
#include <utility>

namespace kriva::ui {
namespace {

/// Before the numbers of panels, which take as long as they like.
constexpr int kPriority = 1;

[[nodiscard]] std::vector<CanvasCurve> drawnCurves(std::vector<CurveToDraw> curves, const SheetView& view,
                                                   WorkBudget& budget) {
    std::vector<CanvasCurve> drawn;
    for (CurveToDraw& next : curves) {
        next.context.view = &view;
        if (!draw(next.shown, *next.curve, next.context, budget))
            return {};
        next.shown.box = boxOf(next.shown.figure);
        drawn.push_back(std::move(next.shown));
    }
    return drawn;
}

} // namespace

bool draw(CanvasCurve& shown, const Curve& curve, const FigureContext& context, WorkBudget& budget) {
    std::optional<DrawnCurve> drawnCurve = drawn(curve, context, budget);
    if (!drawnCurve)
        return false;
    shown.figure = std::move(drawnCurve->figure);
    shown.grips = std::move(drawnCurve->grips);
    shown.isFigureDue = false;
    return true;
}

FigureWorker::FigureWorker(QThreadPool& pool, Take take)
    : pool_(pool)
    , take_(std::move(take)) {}

void FigureWorker::start(std::vector<CurveToDraw> curves, SheetView view) {
    isWorking_ = true;
    stop_ = {};
    auto task = [self = QPointer(this), curves = std::move(curves), view = std::move(view),
                 stop = stop_.get_token()]() mutable {
        WorkBudget budget(WorkBudget::kUnlimited, stop);
        const auto drawn = std::make_shared<std::vector<CanvasCurve>>(drawnCurves(std::move(curves), view, budget));
        const auto deliver = [self, drawn, stop] {
            if (!self || stop.stop_requested())
                return;
            self->isWorking_ = false;
            self->take_(std::move(*drawn)); // once
        };
        QMetaObject::invokeMethod(QCoreApplication::instance(), deliver);
    };
    pool_.start(std::move(task), kPriority);
}

void FigureWorker::cancel() {
    stop_.request_stop();
    isWorking_ = false;
}

} // namespace kriva::ui
