#pragma once

#include "core/document/document.h"
#include "ui/editing/results/curve_work.h"

#include <memory>

namespace kriva::ui {

class ShownSheet;

/// The numbers of the active curve as it is on view, following the changes as far behind as it takes.
class CurveResults : public QObject {
    Q_OBJECT
  public:
    explicit CurveResults(ShownSheet& sheet, QObject* parent = nullptr);

    /// Never null. Shared, as a long spline has hundreds of thousands.
    [[nodiscard]] const std::shared_ptr<const std::vector<Result>>& results() const { return results_; }

  Q_SIGNALS:
    void changed();

  private:
    std::shared_ptr<const std::vector<Result>> results_ = std::make_shared<const std::vector<Result>>();
    CurveWork work_;
};

} // namespace kriva::ui
