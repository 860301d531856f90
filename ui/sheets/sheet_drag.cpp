#include "ui/sheets/sheet_drag.h"

#include "core/document/document_drags.h"
#include "ui/sheets/move_label.h"

#include <QCoreApplication>

namespace kriva::ui {
namespace {

[[nodiscard]] HandleWay::Angle angleOf(const DragKeys& keys) {
    if (!keys.with(Qt::ControlModifier))
        return HandleWay::Angle::free;
    return keys.with(Qt::AltModifier) ? HandleWay::Angle::kept : HandleWay::Angle::stepped;
}

} // namespace

void SheetDrag::reset() {
    pulledAt_.reset();
    handle_.reset();
    offset_ = {};
    way_ = {};
    carriedBefore_ = {};
    spaceSince_.reset();
}

void SheetDrag::begin(const GripRef& grip) {
    reset();
    if (!editor_.selection().contains(grip))
        editor_.select({grip});
    grips_ = editor_.selectedGrips(grip.serial);
    if (grips_.size() == 1 && isHandle(grip.id.kind))
        handle_ = grip.id;
    beginGesture(grip.serial,
                 grips_.size() > 1 ? StepLabel{QT_TRANSLATE_NOOP("Step", "Move points")} : moveLabel(grip.id));
}

void SheetDrag::beginOnCurve(Serial serial, Point at) {
    reset();
    const Curve* curve = editor_.document().find(editor_.index(), serial);
    if (!curve)
        return;
    if (!withCurvePulled(*curve, at, {})) {
        Q_EMIT editor_.hint({QT_TRANSLATE_NOOP("Hint", "This curve follows its points; drag them")});
        return;
    }
    pulledAt_ = at;
    beginGesture(serial, {QT_TRANSLATE_NOOP("Step", "Mould the curve")});
}

void SheetDrag::beginAdding(Point at) {
    reset();
    if (editor_.beginAdding(std::span(&at, 1)))
        pullNewPoint(static_cast<int>(pointCount(*editor_.activeCurve())) - 1, at);
}

void SheetDrag::beginInserting(Serial serial, Point at) {
    reset();
    if (const std::optional<int> point = editor_.beginInserting(serial, at))
        pullNewPoint(*point, at);
}

void SheetDrag::pullNewPoint(int point, Point at) {
    home_ = *editor_.activeCurve();
    PulledPoint pulled = readyToPull(home_, point);
    start_ = std::move(pulled.curve);
    grips_ = {pulled.grip};
    if (!isHandle(pulled.grip.kind))
        return;
    handle_ = pulled.grip;
    offset_ = at - pointAt(home_, point);
}

void SheetDrag::beginGesture(Serial serial, const StepLabel& label) {
    OpenDocument& document = editor_.document();
    editor_.setStage({});
    document.beginGesture(editor_.index(), serial, label);
    if (document.hasGesture())
        home_ = start_ = document.gestureStart();
}

void SheetDrag::move(Vector by, const DragKeys& keys) {
    OpenDocument& document = editor_.document();
    if (document.hasGesture())
        document.preview(moved(by, keys));
}

Curve SheetDrag::moved(Vector by, const DragKeys& keys) {
    if (handle_) {
        followSpace(by, keys.isSpaceHeld);
        followAlt(keys.with(Qt::AltModifier) && !keys.with(Qt::ControlModifier));
        way_.by = by + offset_;
        way_.angle = angleOf(keys);
    }
    if (by == Vector{} &&
        way_.carried == Vector{}) // what is brought home is as it was, handles that were not stored yet included
        return home_;
    if (handle_)
        return withHandleDragged(start_, *handle_, way_);
    if (pulledAt_)
        return withCurvePulled(start_, *pulledAt_, by).value_or(start_);
    return withGripsMoved(start_, grips_, by);
}

void SheetDrag::followSpace(Vector by, bool isHeld) {
    if (isHeld && !spaceSince_)
        spaceSince_ = by;
    if (!spaceSince_)
        return;
    way_.carried = carriedBefore_ + (by - *spaceSince_);
    if (isHeld)
        return;
    carriedBefore_ = way_.carried;
    spaceSince_.reset();
}

void SheetDrag::followAlt(bool isHeld) {
    if (!isHeld)
        way_.opposite.reset();
    else if (!way_.opposite)
        way_.opposite = oppositeHandle(*editor_.activeCurve(), *handle_); // where it is now
}

void SheetDrag::end() {
    editor_.document().endGesture();
    reset();
}

void SheetDrag::cancel() {
    editor_.document().cancelGesture();
    reset();
}

} // namespace kriva::ui
