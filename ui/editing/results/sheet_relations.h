#pragma once

#include "core/document/document.h"
#include "ui/editing/results/coalescing_worker.h"

namespace kriva::ui {

class ShownSheet;

/// What the curves on view have with each other, following the changes as far behind as it takes.
class SheetRelations : public QObject {
    Q_OBJECT
  public:
    explicit SheetRelations(ShownSheet& sheet, QObject* parent = nullptr);

    [[nodiscard]] const Relations& relations() const { return relations_; }

  Q_SIGNALS:
    void changed();

  private:
    void take(Relations relations);

    Relations relations_;
    CoalescingWorker work_;
};

} // namespace kriva::ui
