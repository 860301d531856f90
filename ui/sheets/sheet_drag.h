#pragma once

#include "ui/sheets/sheet_editor.h"

namespace kriva::ui {

/// A drag on the canvas of one sheet: one of the begins, then any number of moves, then end or cancel. What it gives is
/// computed from the curve as it was when the drag began.
class SheetDrag {
  public:
    explicit SheetDrag(SheetEditor& editor)
        : editor_(editor) {}

    /// Of the selection, or of the grip alone where it is not part of it.
    void begin(const GripRef& grip);
    /// Of the curve itself, taken hold of at `at`; refused with a hint where it gives way to no pull.
    void beginOnCurve(Serial serial, Point at);
    /// Of a point that is added at `at` to the active curve; both are one step.
    void beginAdding(Point at);
    /// `by` is the whole way since the drag began.
    void move(Vector by);
    void end();
    void cancel();

  private:
    void beginGesture(Serial serial, const StepLabel& label);

    SheetEditor& editor_;
    Curve start_;
    std::vector<GripId> grips_;
    std::optional<Point> pulledAt_; ///< where the curve itself is dragged
};

} // namespace kriva::ui
