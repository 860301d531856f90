#pragma once

#include "ui/canvas/canvas_client.h"
#include "ui/sheets/hints/hint.h"
#include "ui/sheets/shown_sheet.h"

namespace kriva::ui {

/// Edits a sheet of the open document. A tab's canvas and panels all work on this one object.
class SheetEditor : public ShownSheet {
    Q_OBJECT
  public:
    using ShownSheet::ShownSheet;

    // Points.
    void addPoint(Point at);
    /// At the end of the active curve, in one step.
    void addPoints(std::span<const Point> points);
    /// The same as a gesture that goes on, with the last of the points selected; false where they are refused.
    bool beginAdding(std::span<const Point> points);
    /// One point more near a place of the curve, which keeps its shape; the new point nearest to it is selected.
    void insertPoint(Serial serial, Point near);
    /// The same as a gesture that goes on; gives the new point, nothing where it is refused.
    std::optional<int> beginInserting(Serial serial, Point near);
    /// One point more in the middle behind the selected one of the active curve, else where there is most room, so that
    /// pressing Insert again and again walks along the curve.
    void insertPointBehindSelected();
    void removePoints(Serial serial, const std::vector<int>& indices, Removal removal);
    void removeSelected(Removal removal);
    void removeLastPoint();
    /// A point of the active curve, placed by typing.
    void placePoint(int index, Point at);
    void nudge(Vector by);

    // The active curve. `label` is marked with QT_TRANSLATE_NOOP("Step", ...).
    void change(Curve value, const StepLabel& label);
    /// As change, but steps of the same kind that follow each other closely become one.
    void changeInBurst(Curve value, const StepLabel& label);
    void reverse();
    void retractHandle(const GripRef& handle);
    /// Closes an open chain at its first point; false for any other point.
    bool closeAt(const GripRef& point);

    // Curves.
    void newCurve();
    void duplicateCurve(Serial serial);
    void deleteCurve(Serial serial);
    void renameCurve(Serial serial, const QString& name);
    void colorCurve(Serial serial, Color color);
    void moveCurve(Serial serial, int to);
    void activateNextCurve();
    /// Deletes all curves in one step.
    void clear();

  Q_SIGNALS:
    /// Something worth telling in the status row happened.
    void hint(const kriva::ui::Hint& hint);

  private:
    std::optional<int> beginInserting(Serial serial, std::optional<Edited<Curve>> edited, Point near);
    void tellRemoval(const Curve& before, const Curve& after, std::optional<double> deviation);
};

} // namespace kriva::ui
