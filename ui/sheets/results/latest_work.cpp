#include "ui/sheets/results/latest_work.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QPointer>
#include <QThread>
#include <QThreadPool>

#include <algorithm>
#include <utility>

namespace kriva::ui {
namespace {

/// In nanoseconds an eighth of a frame: there are several such works, and drawing needs most of it.
constexpr qint64 kQuick = 2'000'000;

/// One core stays with the window, or a drag waits for results that are out of date already.
[[nodiscard]] QThreadPool& workers() {
    QThreadPool& pool = *QThreadPool::globalInstance();
    pool.setMaxThreadCount(std::max(1, QThread::idealThreadCount() - 1));
    return pool;
}

} // namespace

LatestWork::LatestWork(std::function<Work()> next, QObject* parent)
    : QObject(parent)
    , next_(std::move(next)) {
    pending_.setSingleShot(true);
    pending_.setInterval(0);
    connect(&pending_, &QTimer::timeout, this, &LatestWork::doNow);
    doSoon();
}

void LatestWork::doSoon() {
    if (!pending_.isActive())
        pending_.start();
}

void LatestWork::startOver() {
    isQuick_ = false;
    doSoon();
}

void LatestWork::doNow() {
    isOutOfDate_ = isWorking_;
    if (isWorking_)
        return;
    if (!isQuick_)
        return doElsewhere(next_());
    QElapsedTimer clock;
    clock.start();
    const Take take = next_()();
    finish(take, clock.nsecsElapsed());
}

void LatestWork::doElsewhere(Work work) {
    isWorking_ = true;
    const auto task = [self = QPointer(this), work = std::move(work)] {
        QElapsedTimer clock;
        clock.start();
        const auto deliver = [self, take = work(), took = clock.nsecsElapsed()] {
            if (!self)
                return;
            self->isWorking_ = false;
            if (self->isOutOfDate_ || self->pending_.isActive())
                self->doSoon();
            else
                self->finish(take, took);
        };
        QMetaObject::invokeMethod(QCoreApplication::instance(), deliver);
    };
    workers().start(task);
}

void LatestWork::finish(const Take& take, qint64 nanoseconds) {
    isQuick_ = nanoseconds < kQuick;
    take();
}

} // namespace kriva::ui
