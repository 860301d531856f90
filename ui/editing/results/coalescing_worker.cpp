#include "ui/editing/results/coalescing_worker.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QPointer>
#include <QThreadPool>

#include <utility>

namespace kriva::ui {
namespace {

/// In nanoseconds an eighth of a frame: there are several such works, and drawing needs most of it.
constexpr qint64 kQuick = 2'000'000;

/// What was quick may be long all of a sudden: after these steps, a frame at most, it goes on elsewhere.
constexpr std::uint64_t kQuickSteps = 100'000;

} // namespace

CoalescingWorker::CoalescingWorker(QThreadPool& pool, std::function<Work()> next, std::uint64_t steps)
    : pool_(pool)
    , next_(std::move(next))
    , steps_(steps) {
    pending_.setSingleShot(true);
    pending_.setInterval(0);
    connect(&pending_, &QTimer::timeout, this, &CoalescingWorker::doNow);
    doSoon();
}

CoalescingWorker::~CoalescingWorker() {
    stop_.request_stop();
}

void CoalescingWorker::doSoon() {
    stop_.request_stop();
    if (!pending_.isActive())
        pending_.start();
}

void CoalescingWorker::startOver() {
    isQuick_ = false;
    doSoon();
}

void CoalescingWorker::doNow() {
    isOutOfDate_ = isWorking_;
    if (isWorking_)
        return;
    Work work = next_();
    if (!isQuick_ || !doHere(work))
        doElsewhere(std::move(work));
}

bool CoalescingWorker::doHere(const Work& work) {
    QElapsedTimer clock;
    clock.start();
    WorkBudget budget(kQuickSteps);
    const Take take = work(budget);
    isQuick_ = !budget.end() && clock.nsecsElapsed() < kQuick;
    if (budget.end())
        return false;
    take();
    return true;
}

void CoalescingWorker::doElsewhere(Work work) {
    isWorking_ = true;
    stop_ = {};
    auto task = [self = QPointer(this), work = std::move(work), steps = steps_, stop = stop_.get_token()] {
        QElapsedTimer clock;
        clock.start();
        WorkBudget budget(steps, stop);
        const auto deliver = [self, take = work(budget), took = clock.nsecsElapsed()] {
            if (!self)
                return;
            self->isWorking_ = false;
            if (self->isOutOfDate_ || self->pending_.isActive())
                return self->doSoon();
            self->isQuick_ = took < kQuick;
            take();
        };
        QMetaObject::invokeMethod(QCoreApplication::instance(), deliver);
    };
    pool_.start(std::move(task)); // with all that it looks at
}

} // namespace kriva::ui
