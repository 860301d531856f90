#include "ui/editing/results/curve_work.h"

#include "ui/editing/sheet/shown_sheet.h"

namespace kriva::ui {

CurveWork::CurveWork(ShownSheet& sheet, Work work, QObject* parent)
    : QObject(parent)
    , work_(sheet.workers(), [&sheet, work = std::move(work)]() -> CoalescingWorker::Work {
        return [work, curve = sheet.snapshot(sheet.activeSerial())](WorkBudget& budget) {
            return work(curve.get(), budget);
        };
    }) {
    const auto startOver = [this] {
        if (isWatched_)
            work_.startOver();
    };
    connect(&sheet.document(), &OpenDocument::replaced, this, startOver);
    connect(&sheet.document(), &OpenDocument::curvesChanged, this, startOver);
    connect(&sheet.document(), &OpenDocument::viewChanged, this, startOver);
    connect(&sheet, &ShownSheet::shownCurveChanged, this, [this, &sheet](Serial serial) {
        if (isWatched_ && serial == sheet.activeSerial())
            work_.doSoon();
    });
}

void CurveWork::setWatched(bool isWatched) {
    if (isWatched && !isWatched_)
        work_.startOver();
    isWatched_ = isWatched;
}

} // namespace kriva::ui
