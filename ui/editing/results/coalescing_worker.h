#pragma once

#include "core/budget/work_budget.h"

#include <QObject>
#include <QTimer>

#include <functional>

class QThreadPool;

namespace kriva::ui {

/// Something worked out again after every change, once per turn of the event loop: at once where it was quick the last
/// time, else on a thread of the pool. A newer change ends what is being worked out there; what comes of it is dropped.
class CoalescingWorker : public QObject {
    Q_OBJECT
  public:
    /// Takes what was worked out, on the thread of the window.
    using Take = std::function<void()>;
    /// The work itself, on any thread: it holds copies of all that it looks at, and spends its budget in every loop
    /// that may be long.
    using Work = std::function<Take(WorkBudget&)>;

    /// `next` gathers what is to be worked out at the moment, in so many steps; what comes of it after them is taken
    /// all the same. The pool outlives this; never Qt's global one, for whose threads the raster engine waits while it
    /// paints. No take is called after the end of this object.
    CoalescingWorker(QThreadPool& pool, std::function<Work()> next, std::uint64_t steps = WorkBudget::kUnlimited);
    ~CoalescingWorker() override;

    /// Something changed.
    void doSoon();
    /// Something else altogether is shown: how long it takes is not known.
    void startOver();

  private:
    void doNow();
    [[nodiscard]] bool doHere(const Work& work);
    void doElsewhere(Work work);

    QThreadPool& pool_;
    std::function<Work()> next_;
    std::uint64_t steps_;
    QTimer pending_;
    std::stop_source stop_;    ///< of what is being worked out elsewhere
    bool isWorking_ = false;   ///< on another thread
    bool isOutOfDate_ = false; ///< what is being worked out there
    bool isQuick_ = false;     ///< it took less than an eighth of a frame the last time
};

} // namespace kriva::ui
