#pragma once

#include "core/curve/editing/handle_way.h"
#include "ui/canvas/base/snapping.h"
#include "ui/editing/sheet_editor.h"

namespace kriva::ui {

/// The grips moved so that one that stands at `from` stands at `to`, bit for bit.
[[nodiscard]] Curve withGripsCarried(const Curve& curve, std::span<const GripId> ids, Point from, Point to);

/// A drag on the canvas of one sheet, a gesture of the document: one of the begins, then any number of moves, then end
/// or cancel. A move previews what is computed from the curve as it was when the drag began, and the end makes that one
/// step. The curve that is dragged becomes the active one.
class SheetDrag {
  public:
    explicit SheetDrag(SheetEditor& editor)
        : editor_(editor) {}

    /// Of the selection, which the grip is part of.
    void begin(const GripRef& grip);
    /// Of the curve itself, taken hold of at `at`; refused with a hint where it gives way to no pull.
    void beginOnCurve(Serial serial, Point at);
    /// Of a point that is added at `at` to the active curve, or of its handles; both are one step.
    void beginAdding(Point at);
    /// The same of a point that is inserted into a curve near `at`.
    void beginInserting(Serial serial, Point at);
    /// Where the point that was taken hold of would stand after the whole displacement `by` since the drag began;
    /// nothing where it does not snap. It holds until the next begin.
    [[nodiscard]] std::optional<SnappingPlace> snappingPlace(Vector by, const DragKeys& keys);
    /// `by` is the whole displacement since the drag began, which Ctrl locks to an axis for a point; `snapped`, where
    /// the point that was taken hold of comes to stand.
    void move(Vector by, const DragKeys& keys, std::optional<Point> snapped = {});
    void end();
    void cancel();

    /// What is dragged around its point; nothing for all else.
    [[nodiscard]] std::optional<GripId> handle() const { return handle_; }

  private:
    void beginGesture(Serial serial, const StepLabel& label);
    void reset();
    void pullNewPoint(int point, Point at);
    [[nodiscard]] Vector allowed(Vector by, const DragKeys& keys) const;
    [[nodiscard]] Curve moved(Vector by, const DragKeys& keys, std::optional<Point> snapped);
    void followSpace(Vector by, bool isHeld);
    void followAlt(bool isHeld);

    SheetEditor& editor_;
    Curve home_; ///< where nothing has moved yet
    Curve start_;
    Serial serial_ = 0;
    std::vector<GripId> grips_;
    std::optional<Point> from_;        ///< where the point that was taken hold of stood, where it snaps
    bool canLock_ = false;             ///< to an axis
    bool mayShiftSwitch_ = false;      ///< snapping off: Shift pressed before the drag added to the selection
    std::optional<Point> pulledAt_;    ///< where the curve itself is dragged
    std::optional<GripId> handle_;     ///< where it is the one thing dragged
    Vector offset_;                    ///< from the point whose handles are pulled to the press
    HandleWay way_;                    ///< of the handle
    Vector carriedBefore_;             ///< what Space carried until it was released
    std::optional<Vector> spaceSince_; ///< the way at which Space went down
};

} // namespace kriva::ui
