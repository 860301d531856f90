#include "ui/canvas/drags.h"

#include "core/document/document_drags.h"
#include "ui/canvas/canvas_view.h"

#include <cmath>

namespace kriva::ui {
namespace {

[[nodiscard]] Vector lockedToAxis(Vector way) {
    return std::abs(way.x) >= std::abs(way.y) ? Vector{way.x, 0} : Vector{0, way.y};
}

void takeGrip(const Press& press, const GripRef& grip, const Selection& selection, CanvasClient& client) {
    if (!selection.contains(grip)) {
        const bool isAdding = press.with(Qt::ShiftModifier);
        client.select(isAdding ? united(selection, {grip}) : Selection{grip});
    }
    client.beginDrag(grip);
}

} // namespace

DragKind beginDrag(const Press& press, CanvasView& view, CanvasClient& client) {
    const bool isAlt = press.with(Qt::AltModifier);
    if (press.button == Qt::RightButton)
        return DragKind::none;
    if (press.under.grip && !isAlt)
        takeGrip(press, *press.under.grip, view.selection(), client);
    else if (isAlt || press.with(Qt::ShiftModifier))
        return DragKind::band;
    else if (press.under.curve && view.tool() == Tool::add)
        client.beginInsertDrag(*press.under.curve, press.at);
    else if (press.under.curve)
        client.beginCurveDrag(*press.under.curve, press.at);
    else if (view.tool() == Tool::add)
        client.beginAddDrag(press.at);
    else
        return DragKind::band;
    return DragKind::drag;
}

Vector wayOf(const Press& press, Point now, Qt::KeyboardModifiers modifiers) {
    const Vector way = now - press.at;
    const bool isLocked =
        modifiers.testFlag(Qt::ControlModifier) && press.under.grip && !isHandle(press.under.grip->id.kind);
    return isLocked ? lockedToAxis(way) : way;
}

} // namespace kriva::ui
