#pragma once

#include "core/document/document.h"
#include "ui/canvas/canvas_curves.h"

#include <QObject>

#include <functional>
#include <memory>

class QThreadPool;

namespace kriva::ui {

/// A curve as it is to be drawn, apart from the document: any thread may do it.
struct CurveToDraw {
    CanvasCurve shown; ///< all but what drawing gives
    std::shared_ptr<const Curve> curve;
    FigureContext context; ///< without the view
};

/// Works out beside the window what a canvas shows of curves.
class FigureWorker : public QObject {
    Q_OBJECT
  public:
    using Take = std::function<void(std::vector<CanvasCurve>)>;

    /// The pool outlives this; never Qt's global one, for whose threads the raster engine waits while it paints. `take`
    /// is called on the thread of the window, and not after the end of this object.
    FigureWorker(QThreadPool& pool, Take take);
    ~FigureWorker() override { cancel(); }

    /// Until they are taken or cancelled.
    [[nodiscard]] bool isWorking() const { return isWorking_; }
    void start(std::vector<CurveToDraw> curves, SheetView view);
    /// Nothing comes of them.
    void cancel();

  private:
    QThreadPool& pool_;
    Take take_;
    std::stop_source stop_;
    bool isWorking_ = false;
};

/// Fills in what drawing gives; false where the budget ends. The view outlives this call alone.
[[nodiscard]] bool draw(CanvasCurve& shown, const Curve& curve, const FigureContext& context, WorkBudget& budget);

} // namespace kriva::ui
