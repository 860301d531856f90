#include "ui/editing/results/sheet_relations.h"

#include "core/curve/limits.h"
#include "ui/editing/sheet/shown_sheet.h"

#include <algorithm>
#include <memory>

namespace kriva::ui {
namespace {

std::vector<std::shared_ptr<const Curve>> curvesOnView(const ShownSheet& sheet) {
    std::vector<std::shared_ptr<const Curve>> curves;
    for (const Serial serial : sheet.document().serials(sheet.index()))
        curves.push_back(sheet.snapshot(serial));
    return curves;
}

} // namespace

SheetRelations::SheetRelations(ShownSheet& sheet, QObject* parent)
    : QObject(parent)
    , work_(
          sheet.workers(),
          [this, &sheet]() -> CoalescingWorker::Work {
              return [this, curves = curvesOnView(sheet),
                      index = sheet.index()](WorkBudget& budget) -> CoalescingWorker::Take {
                  std::vector<const Curve*> pointers(curves.size());
                  std::ranges::transform(curves, pointers.begin(), &std::shared_ptr<const Curve>::get);
                  auto found = relationsOf(pointers, index, budget).value_or(Relations());
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
