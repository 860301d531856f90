#pragma once

#include "core/geometry/point.h"
#include "ui/canvas/base/selection.h"

#include <Qt>

namespace kriva::ui {

/// Whether the neighbours of a removed point are refitted so that the shape changes least.
enum class Removal { refitted, plain };

/// What is held while a drag goes on.
struct DragKeys {
    Qt::KeyboardModifiers modifiers;
    bool isSpaceHeld = false;

    [[nodiscard]] bool with(Qt::KeyboardModifier modifier) const { return modifiers.testFlag(modifier); }
};

/// What a person wants from the canvas, told to the tab that owns the values. The canvas changes nothing by itself:
/// it shows the answer when it is given new curves or a new selection. All places are in document units.
class CanvasClient {
  public:
    virtual ~CanvasClient() = default;

    /// A new point at the end of the active curve: Alt+click off any point, a click with the Add tool, double-click on
    /// empty canvas.
    virtual void addPoint(Point at) = 0;
    /// A click on a point with the Add tool: closes a chain on its first knot; elsewhere one more point at `at`.
    virtual void addPointOn(GripRef grip, Point at) = 0;
    /// A point that keeps the curve's shape, near `at`: double-click or Ctrl+Alt+click on a curve, a click on one with
    /// the Add tool.
    virtual void insertPoint(Serial curve, Point at) = 0;
    /// The Insert key with the pointer off any curve: a point that keeps the active curve's shape, behind the selected
    /// one.
    virtual void insertPointBehindSelected() = 0;
    virtual void removePoint(GripRef grip) = 0;
    virtual void removeSelected(Removal removal) = 0;
    /// Ctrl+click on a handle.
    virtual void retractHandle(GripRef handle) = 0;

    virtual void select(Selection selection) = 0;
    virtual void activateCurve(Serial curve) = 0;
    /// A click on a mark, with the edit tool.
    virtual void explain(const MarkPlace& mark) = 0;

    // One of the begins, then any number of drag, then endDrag or cancelDrag.

    /// The grip is part of the selection by now, which moves with it.
    virtual void beginDrag(GripRef grip) = 0;
    /// A drag with the Add tool off any point: adds a point at `at` whose handles follow the drag.
    virtual void beginAddDrag(Point at) = 0;
    /// The same on a curve, into which the point is inserted.
    virtual void beginInsertDrag(Serial curve, Point at) = 0;
    /// The curve was taken hold of at `at`, which is to stay under the pointer.
    virtual void beginCurveDrag(Serial curve, Point at) = 0;
    /// `by` is the whole way since the press. For points Ctrl has locked it to an axis already; what keys mean for
    /// handles, and Shift for snapping, is the client's to apply. Told anew when one is pressed or released.
    virtual void drag(Vector by, const DragKeys& keys) = 0;
    virtual void endDrag() = 0;
    virtual void cancelDrag() = 0;

    /// Moves the selection: an arrow key.
    virtual void nudge(Vector by) = 0;

    /// The pointer is at `at`, over what `under` says; also told when a modifier key is pressed or released.
    virtual void hover(const Hit& under, Point at, Qt::KeyboardModifiers modifiers) = 0;
};

} // namespace kriva::ui
