#pragma once

#include "ui/canvas/canvas_input.h"
#include "ui/editing/hints/hint.h"
#include "ui/editing/sheet/sheet_curves.h"

namespace kriva::ui {

/// Edits a sheet of the open document: its curves, and here their points. A tab's canvas and panels all work on this
/// one object.
class SheetEditor : public SheetCurves {
    Q_OBJECT
  public:
    using SheetCurves::SheetCurves;

    /// At the end of the active curve; false where it is refused.
    bool addPoint(Point at);
    /// At the end of the active curve, as a gesture that goes on, with the point selected; false where it is refused.
    bool beginAdding(Point at);
    /// The points of a curve of this sheet behind those of the active one, in one step; they are selected.
    void append(const Curve& points, const StepLabel& label);
    /// One point more near a place of the curve, which keeps its shape and becomes the active one; the new point
    /// nearest to it is selected.
    void insertPoint(Serial serial, Point near);
    /// The same as a gesture that goes on; gives the new point, nothing where it is refused.
    std::optional<int> beginInserting(Serial serial, Point near);
    /// One point more in the middle behind the selected one of the active curve, else where there is most room, so that
    /// pressing Insert again and again walks along the curve.
    void insertPointBehindSelected();
    /// Without a label the step says which point goes.
    void removePoints(Serial serial, const std::vector<int>& indices, Removal removal,
                      const std::optional<StepLabel>& label = {});
    void removeSelected(Removal removal);
    void removeLastPoint();
    /// A point of the active curve, placed by typing.
    void placePoint(int index, Point at);
    void nudge(Vector by);
    /// The handle's curve becomes the active one.
    void retractHandle(const GripRef& handle);
    /// An open chain closed at its first point; nothing for any other point.
    [[nodiscard]] std::optional<Curve> closedAt(const GripRef& point) const;
    /// False where there is nothing to close.
    bool closeAt(const GripRef& point);

  Q_SIGNALS:
    /// Something worth telling in the status row happened.
    void hint(const kriva::ui::Hint& hint);

  private:
    std::optional<int> beginInserting(Serial serial, std::optional<Edited<Curve>> edited, Point near);
    void tellRemoval(const Curve& before, const Curve& after, std::optional<double> deviation);
};

} // namespace kriva::ui
