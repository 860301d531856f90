#include "ui/sheets/sheet_drag.h"

#include "ui/sheets/move_label.h"

#include <QCoreApplication>

namespace kriva::ui {

namespace {

/// Handles and derivatives are directions: they keep away from the grid.
[[nodiscard]] bool snaps(GripKind kind) {
    return kind == GripKind::point || kind == GripKind::inner || kind == GripKind::middle;
}

[[nodiscard]] std::optional<Point> placeOf(const Curve& curve, const GripId& id) {
    for (const Grip& grip : grips(curve))
        if (grip.id == id)
            return grip.at;
    return {};
}

} // namespace

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
    if (!editor_.selection().contains(grip))
        editor_.select({grip});
    grips_ = editor_.selectedGrips(grip.serial);
    pulledAt_.reset();
    beginGesture(grip.serial,
                 grips_.size() > 1 ? StepLabel{QT_TRANSLATE_NOOP("Step", "Move points")} : moveLabel(grip.id));
    from_ = snaps(grip.id.kind) ? placeOf(start_, grip.id) : std::nullopt;
}

void SheetDrag::beginOnCurve(Serial serial, Point at) {
    const Curve* curve = editor_.document().find(editor_.index(), serial);
    if (!curve)
        return;
    if (!withCurvePulled(*curve, at, {})) {
        Q_EMIT editor_.hint({QT_TRANSLATE_NOOP("Hint", "This curve follows its points; drag them")});
        return;
    }
    pulledAt_ = at;
    from_.reset();
    beginGesture(serial, {QT_TRANSLATE_NOOP("Step", "Mould the curve")});
}

void SheetDrag::beginAdding(Point at) {
    if (!editor_.beginAdding(at))
        return;
    start_ = *editor_.activeCurve();
    serial_ = editor_.activeSerial();
    from_ = at;
    grips_ = editor_.selectedGrips(editor_.activeSerial());
    pulledAt_.reset();
}

void SheetDrag::beginGesture(Serial serial, const StepLabel& label) {
    OpenDocument& document = editor_.document();
    editor_.setStage({});
    serial_ = serial;
    document.beginGesture(editor_.index(), serial, label);
    if (document.hasGesture())
        start_ = document.gestureStart();
}

std::optional<Point> SheetDrag::snappingPlace(Vector by) const {
    return from_ ? std::optional(*from_ + by) : std::nullopt;
}

void SheetDrag::move(Vector by, std::optional<Point> snapped) {
    OpenDocument& document = editor_.document();
    if (!document.hasGesture())
        return;
    if (from_ && snapped)
        document.preview(withGripsCarried(start_, grips_, *from_, *snapped));
    else if (!pulledAt_)
        document.preview(withGripsMoved(start_, grips_, by));
    else if (std::optional<Curve> pulled = withCurvePulled(start_, *pulledAt_, by))
        document.preview(std::move(*pulled));
}

void SheetDrag::end() {
    editor_.document().endGesture();
}

void SheetDrag::cancel() {
    editor_.document().cancelGesture();
}

} // namespace kriva::ui
