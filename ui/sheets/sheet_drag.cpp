#include "ui/sheets/sheet_drag.h"

#include "ui/sheets/move_label.h"

#include <QCoreApplication>

namespace kriva::ui {

void SheetDrag::begin(const GripRef& grip) {
    if (!editor_.selection().contains(grip))
        editor_.select({grip});
    grips_ = editor_.selectedGrips(grip.serial);
    pulledAt_.reset();
    beginGesture(grip.serial,
                 grips_.size() > 1 ? StepLabel{QT_TRANSLATE_NOOP("Step", "Move points")} : moveLabel(grip.id));
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
    beginGesture(serial, {QT_TRANSLATE_NOOP("Step", "Mould the curve")});
}

void SheetDrag::beginAdding(Point at) {
    if (!editor_.beginAdding(std::span(&at, 1)))
        return;
    start_ = *editor_.activeCurve();
    grips_ = editor_.selectedGrips(editor_.activeSerial());
    pulledAt_.reset();
}

void SheetDrag::beginGesture(Serial serial, const StepLabel& label) {
    OpenDocument& document = editor_.document();
    editor_.setStage({});
    document.beginGesture(editor_.index(), serial, label);
    if (document.hasGesture())
        start_ = document.gestureStart();
}

void SheetDrag::move(Vector by) {
    OpenDocument& document = editor_.document();
    if (!document.hasGesture())
        return;
    if (!pulledAt_)
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
