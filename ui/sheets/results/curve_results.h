#pragma once

#include "core/document/document.h"
#include "ui/sheets/results/curve_work.h"

namespace kriva::ui {

class ShownSheet;

/// The numbers of the active curve as it is on view, following the changes as far behind as it takes.
class CurveResults : public QObject {
    Q_OBJECT
  public:
    explicit CurveResults(ShownSheet& sheet, QObject* parent = nullptr);

    [[nodiscard]] const std::vector<Result>& results() const { return results_; }

  Q_SIGNALS:
    void changed();

  private:
    void take(std::vector<Result> results);

    std::vector<Result> results_;
    CurveWork work_;
};

} // namespace kriva::ui
