#pragma once

#include "core/document/document.h"
#include "ui/editing/results/coalescing_worker.h"

namespace kriva::ui {

class ShownSheet;

/// Something worked out from the active curve as it is on view, following the changes as far behind as it takes; only
/// as long as somebody looks at it.
class CurveWork : public QObject {
    Q_OBJECT
  public:
    /// Gives what takes the outcome, on the thread of the window; called on any thread. Null without a curve.
    using Work = std::function<CoalescingWorker::Take(const Curve*, WorkBudget&)>;

    CurveWork(ShownSheet& sheet, Work work, QObject* parent = nullptr);

    /// It is looked at from the beginning.
    void setWatched(bool isWatched);

  private:
    bool isWatched_ = true;
    CoalescingWorker work_;
};

} // namespace kriva::ui
