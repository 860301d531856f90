#include "ui/editing/results/sheet_relations.h"

#include "core/curve/limits.h"
#include "ui/editing/sheet/shown_sheet.h"

#include <memory>

namespace kriva::ui {

SheetRelations::SheetRelations(ShownSheet& sheet, QObject* parent)
    : QObject(parent)
    , work_(
          sheet.workers(),
          [this, &sheet]() -> CoalescingWorker::Work {
              return [this, onView = sheet.sheetOnView(),
                      index = sheet.index()](WorkBudget& budget) -> CoalescingWorker::Take {
                  auto found = relationsOf(onView, index, budget).value_or(Relations());
                  return [this, relations = std::make_shared<Relations>(std::move(found))] {
                      take(std::move(*relations)); // once
                  };
              };
          },
          limits::kSteps) {
    connect(&sheet.document(), &OpenDocument::replaced, &work_, &CoalescingWorker::startOver);
    connect(&sheet.document(), &OpenDocument::curvesChanged, &work_, &CoalescingWorker::doSoon);
    connect(&sheet.document(), &OpenDocument::viewChanged, &work_, &CoalescingWorker::doSoon);
    connect(&sheet, &ShownSheet::shownCurveChanged, &work_, &CoalescingWorker::doSoon);
}

void SheetRelations::take(Relations relations) {
    if (relations.results.empty() && relations_.results.empty())
        return;
    relations_ = std::move(relations);
    Q_EMIT changed();
}

} // namespace kriva::ui
