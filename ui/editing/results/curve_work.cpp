#include "ui/editing/results/curve_work.h"

#include "ui/editing/sheet/shown_sheet.h"

namespace kriva::ui {
namespace {

std::optional<Curve> activeOnView(const ShownSheet& sheet) {
    const Curve* curve = sheet.shown(sheet.activeSerial());
    return curve ? std::optional(*curve) : std::nullopt;
}

} // namespace

CurveWork::CurveWork(ShownSheet& sheet, Work work, QObject* parent)
    : QObject(parent)
    , work_(sheet.workers(), [&sheet, work = std::move(work)]() -> CoalescingWorker::Work {
        return [work, curve = activeOnView(sheet)](WorkBudget& budget) { return work(curve, budget); };
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
