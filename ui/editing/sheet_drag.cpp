#include "ui/editing/sheet_drag.h"

#include "core/document/document_drags.h"
#include "ui/editing/sheet/move_label.h"

#include <QCoreApplication>

#include <cmath>

namespace kriva::ui {
namespace {

[[nodiscard]] HandleWay::Angle angleOf(const DragKeys& keys) {
    if (!keys.with(Qt::ControlModifier))
        return HandleWay::Angle::free;
    return keys.with(Qt::AltModifier) ? HandleWay::Angle::kept : HandleWay::Angle::stepped;
}

[[nodiscard]] std::optional<Point> placeOf(const Curve& curve, const GripId& id) {
    for (const Grip& grip : grips(curve))
        if (grip.id == id)
            return grip.at;
    return {};
}

} // namespace

void SheetDrag::reset() {
    from_.reset();
    canLock_ = false;
    mayShiftSwitch_ = false;
    pulledAt_.reset();
    handle_.reset();
    offset_ = {};
    way_ = {};
    carriedBefore_ = {};
    spaceSince_.reset();
}

Curve withGripsCarried(const Curve& curve, std::span<const GripId> ids, Point from, Point to) {
    if (to == from)
        return curve;
    // By way of zero: x - x + to is `to`, x + (to - x) need not be.
    const bool changesX = to.x != from.x;
    const bool changesY = to.y != from.y;
    const Curve atZero = withGripsMoved(curve, ids, {changesX ? -from.x : 0, changesY ? -from.y : 0});
    return withGripsMoved(atZero, ids, {changesX ? to.x : 0, changesY ? to.y : 0});
}

void SheetDrag::begin(const GripRef& grip) {
    reset();
    editor_.activate(grip.serial);
    grips_ = editor_.selectedGrips(grip.serial);
    if (grips_.size() == 1 && isHandle(grip.id.kind))
        handle_ = grip.id;
    beginGesture(grip.serial,
                 grips_.size() > 1 ? StepLabel{QT_TRANSLATE_NOOP("Step", "Move points")} : moveLabel(grip.id));
    canLock_ = !isHandle(grip.id.kind); // handles and derivatives are directions: they keep away from the grid too
    from_ = canLock_ ? placeOf(start_, grip.id) : std::nullopt;
}

void SheetDrag::beginOnCurve(Serial serial, Point at) {
    reset();
    editor_.activate(serial);
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
    if (editor_.beginAdding(at))
        pullNewPoint(static_cast<int>(pointCount(*editor_.activeCurve())) - 1, at);
}

void SheetDrag::beginInserting(Serial serial, Point at) {
    reset();
    if (const std::optional<int> point = editor_.beginInserting(serial, at))
        pullNewPoint(*point, at);
}

void SheetDrag::pullNewPoint(int point, Point at) {
    serial_ = editor_.activeSerial();
    home_ = *editor_.activeCurve();
    PulledPoint pulled = readyToPull(home_, point);
    start_ = std::move(pulled.curve);
    grips_ = {pulled.grip};
    if (!isHandle(pulled.grip.kind)) {
        from_ = pointAt(home_, point);
        return;
    }
    handle_ = pulled.grip;
    offset_ = at - pointAt(home_, point);
}

void SheetDrag::beginGesture(Serial serial, const StepLabel& label) {
    OpenDocument& document = editor_.document();
    editor_.setStage({});
    serial_ = serial;
    document.beginGesture(editor_.index(), serial, label);
    if (document.hasGesture())
        home_ = start_ = document.gestureStart();
}

Vector SheetDrag::allowed(Vector by, const DragKeys& keys) const {
    if (!canLock_ || !keys.with(Qt::ControlModifier))
        return by;
    return std::abs(by.x) >= std::abs(by.y) ? Vector{by.x, 0} : Vector{0, by.y};
}

std::optional<SnappingPlace> SheetDrag::snappingPlace(Vector by, const DragKeys& keys) {
    const bool isShift = keys.with(Qt::ShiftModifier);
    mayShiftSwitch_ = mayShiftSwitch_ || !isShift;
    const Vector way = allowed(by, keys);
    const bool isMoved = way != Vector{}; // back home is home, on the grid or not
    if (!from_ || !isMoved || (isShift && mayShiftSwitch_))
        return {};
    const bool isLocked = keys.with(Qt::ControlModifier);
    const Freedom freedom = !isLocked ? Freedom::both : way.y == 0 ? Freedom::x : Freedom::y;
    return SnappingPlace{*from_ + way, freedom, serial_, grips_};
}

void SheetDrag::move(Vector by, const DragKeys& keys, std::optional<Point> snapped) {
    OpenDocument& document = editor_.document();
    if (document.hasGesture())
        document.preview(moved(allowed(by, keys), keys, snapped));
}

Curve SheetDrag::moved(Vector by, const DragKeys& keys, std::optional<Point> snapped) {
    if (handle_) {
        followSpace(by, keys.isSpaceHeld);
        followAlt(keys.with(Qt::AltModifier) && !keys.with(Qt::ControlModifier));
        way_.by = by + offset_;
        way_.angle = angleOf(keys);
    }
    // What is brought home is as it was, handles that were not stored yet included.
    if (by == Vector{} && way_.carried == Vector{})
        return home_;
    if (handle_)
        return withHandleDragged(start_, *handle_, way_);
    if (pulledAt_)
        return withCurvePulled(start_, *pulledAt_, by).value_or(start_);
    if (from_ && snapped)
        return withGripsCarried(start_, grips_, *from_, *snapped);
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
