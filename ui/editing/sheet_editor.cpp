#include "ui/editing/sheet_editor.h"

#include "core/document/conversion.h"
#include "core/document/document_drags.h"
#include "core/geometry/tolerance.h"
#include "ui/editing/sheet/move_label.h"
#include "ui/editing/sheet_drag.h"

#include <QCoreApplication>

namespace kriva::ui {

bool SheetEditor::addPoint(Point at) {
    if (!beginAdding(at))
        return false;
    document().endGesture();
    return true;
}

bool SheetEditor::beginAdding(Point at) {
    const StepLabel label{QT_TRANSLATE_NOOP("Step", "Add a point")};
    if (activeCurve())
        document().beginGesture(index(), activeSerial(), label);
    else if (!document().beginGestureWithNew(index(), 0, emptyCurve(index()), label))
        return false;
    Curve curve = withPointAdded(*activeCurve(), at).curve;
    const std::size_t count = pointCount(curve);
    document().preview(std::move(curve));
    if (pointCount(*activeCurve()) != count) {
        document().cancelGesture();
        return false;
    }
    select({{activeSerial(), {GripKind::point, static_cast<int>(count) - 1}}});
    return true;
}

void SheetEditor::append(const Curve& points, const StepLabel& label) {
    const Curve* curve = activeCurve();
    const std::size_t before = curve ? pointCount(*curve) : 0;
    const bool isDone = curve ? document().change(index(), activeSerial(), appended(*curve, points), label)
                              : document().add(index(), 0, appended(emptyCurve(index()), points), label).has_value();
    if (!isDone)
        return;
    Selection added;
    added.insertPoints(activeSerial(), static_cast<int>(before), static_cast<int>(pointCount(*activeCurve())));
    select(std::move(added));
}

void SheetEditor::insertPoint(Serial serial, Point near) {
    if (beginInserting(serial, near))
        document().endGesture();
}

std::optional<int> SheetEditor::beginInserting(Serial serial, Point near) {
    activate(serial);
    const Curve* curve = document().find(index(), serial);
    if (!curve)
        return {};
    return beginInserting(serial, withPointInserted(*curve, near), near);
}

void SheetEditor::insertPointBehindSelected() {
    const Curve* curve = activeCurve();
    if (!curve || pointCount(*curve) == 0)
        return;
    const std::vector<int> selected = selectedPoints();
    const std::optional<int> point = selected.empty() ? std::nullopt : std::optional(selected.back());
    const int middle = static_cast<int>(pointCount(*curve)) / 2;
    if (beginInserting(activeSerial(), withPointInsertedBehind(*curve, point), pointAt(*curve, point.value_or(middle))))
        document().endGesture();
}

std::optional<int> SheetEditor::beginInserting(Serial serial, std::optional<Edited<Curve>> edited, Point near) {
    if (!edited) {
        Q_EMIT hint({QT_TRANSLATE_NOOP("Hint", "No point can be inserted here")});
        return {};
    }
    const int point = newPointNear(*edited, near);
    const std::size_t count = pointCount(edited->curve);
    document().beginGesture(index(), serial, {QT_TRANSLATE_NOOP("Step", "Insert a point")});
    document().preview(std::move(edited->curve));
    if (pointCount(*document().find(index(), serial)) != count) {
        document().cancelGesture();
        return {};
    }
    select({{serial, {GripKind::point, point}}});
    return point;
}

void SheetEditor::removePoints(Serial serial, const std::vector<int>& indices, Removal removal,
                               const std::optional<StepLabel>& label) {
    const Curve* curve = document().find(index(), serial);
    if (!curve || indices.empty())
        return;
    const Curve before = *curve;
    Refitted<Curve> refitted = removal == Removal::refitted ? withPointsRemovedRefitted(before, indices)
                                                            : Refitted<Curve>{withPointsRemoved(before, indices), {}};
    const StepLabel usual = indices.size() == 1 ? StepLabel{QT_TRANSLATE_NOOP("Step", "Remove point %1"), indices[0]}
                                                : StepLabel{QT_TRANSLATE_NOOP("Step", "Remove points")};
    const Selection selected = selection(); // the change drops what lies beyond the end; the map knows where it went
    if (document().change(index(), serial, std::move(refitted.edited.curve), label.value_or(usual))) {
        selectMapped(selected, serial, refitted.edited.map);
        tellRemoval(before, *document().find(index(), serial), refitted.deviation);
    }
}

void SheetEditor::tellRemoval(const Curve& before, const Curve& after, std::optional<double> deviation) {
    const std::optional<int> degree = polynomialDegree(after);
    if (deviation && *deviation <= kRoundingPart * diagonal(boxOf(pointsOf(before))))
        Q_EMIT hint({QT_TRANSLATE_NOOP("Hint", "The shape stays as it is")});
    else if (deviation)
        Q_EMIT hint({QT_TRANSLATE_NOOP("Hint", "The shape changes by at most %1"), deviation});
    else if (degree && degree != polynomialDegree(before))
        Q_EMIT hint({QT_TRANSLATE_NOOP("Hint", "The degree falls to %1"), degree});
}

void SheetEditor::removeSelected(Removal removal) {
    removePoints(activeSerial(), selectedPoints(), removal);
}

void SheetEditor::removeLastPoint() {
    if (const Curve* curve = activeCurve(); curve && pointCount(*curve) > 0)
        removePoints(activeSerial(), {static_cast<int>(pointCount(*curve)) - 1}, Removal::plain);
}

void SheetEditor::placePoint(int index, Point at) {
    const Curve* curve = activeCurve();
    if (!curve)
        return;
    const GripId id{GripKind::point, index};
    change(withGripsCarried(*curve, std::span(&id, 1), pointAt(*curve, index), at), moveLabel(id));
}

void SheetEditor::nudge(Vector by) {
    const Curve* curve = activeCurve();
    const std::vector<GripId> ids = selectedGrips(activeSerial());
    if (curve && !ids.empty())
        changeInBurst(withGripsMoved(*curve, ids, by), {QT_TRANSLATE_NOOP("Step", "Nudge")});
}

void SheetEditor::retractHandle(const GripRef& handle) {
    activate(handle.serial);
    const Curve* curve = document().find(index(), handle.serial);
    std::optional<Curve> retracted = curve ? withHandleRetracted(*curve, handle.id) : std::nullopt;
    if (retracted)
        document().change(index(), handle.serial, std::move(*retracted), retractLabel(handle.id));
}

std::optional<Curve> SheetEditor::closedAt(const GripRef& point) const {
    const bool isPoint = point.serial == activeSerial() && point.id.kind == GripKind::point;
    return isPoint ? kriva::closedAt(*activeCurve(), point.id.index) : std::nullopt;
}

bool SheetEditor::closeAt(const GripRef& point) {
    std::optional<Curve> closed = closedAt(point);
    if (!closed)
        return false;
    change(std::move(*closed), {QT_TRANSLATE_NOOP("Step", "Close the curve")});
    return true;
}

} // namespace kriva::ui
