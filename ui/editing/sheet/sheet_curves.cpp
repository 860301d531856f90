#include "ui/editing/sheet/sheet_curves.h"

#include "core/document/conversion.h"
#include "ui/base/language/plain_text.h"

#include <QCoreApplication>

namespace kriva::ui {

void SheetCurves::change(Curve value, const StepLabel& label) {
    document().change(index(), activeSerial(), std::move(value), label);
}

void SheetCurves::changeInBurst(Curve value, const StepLabel& label) {
    document().changeInBurst(index(), activeSerial(), std::move(value), label);
}

void SheetCurves::divide(Curve first, Curve second, const StepLabel& label) {
    document().divide(index(), activeSerial(), std::move(first), std::move(second), label);
}

void SheetCurves::reverse() {
    const Curve* curve = activeCurve();
    if (!curve)
        return;
    Edited<Curve> edited = reversed(*curve);
    const Selection selected = selection();
    change(std::move(edited.curve), {QT_TRANSLATE_NOOP("Step", "Reverse the curve")});
    selectMapped(selected, activeSerial(), edited.map);
}

bool SheetCurves::newCurve() {
    return addCurve(emptyCurve(index()), {QT_TRANSLATE_NOOP("Step", "New curve")});
}

void SheetCurves::beginCurve() {
    if (newCurve())
        Q_EMIT drawingBegun();
}

void SheetCurves::beginAnew() {
    clear();
    Q_EMIT drawingBegun();
}

bool SheetCurves::addCurve(Curve curve, const StepLabel& label) {
    const int last = static_cast<int>(sheet().curves.size());
    return document().add(index(), last, std::move(curve), label).has_value();
}

bool SheetCurves::addCurves(std::vector<Curve> curves, const StepLabel& label) {
    return document().addAll(index(), std::move(curves), label);
}

void SheetCurves::duplicateCurve(Serial serial) {
    if (const Curve* curve = document().find(index(), serial))
        document().add(index(), *document().indexOf(index(), serial) + 1, *curve,
                       {QT_TRANSLATE_NOOP("Step", "Duplicate the curve")});
}

void SheetCurves::deleteCurve(Serial serial) {
    deleteCurve(serial, {QT_TRANSLATE_NOOP("Step", "Delete the curve")});
}

void SheetCurves::deleteCurve(Serial serial, const StepLabel& label) {
    document().remove(index(), serial, label);
}

void SheetCurves::renameCurve(Serial serial, const QString& name) {
    if (const Curve* curve = document().find(index(), serial))
        document().change(index(), serial, renamed(*curve, wellFormed(name).toStdString()),
                          {QT_TRANSLATE_NOOP("Step", "Rename the curve")});
}

void SheetCurves::styleCurve(Serial serial, const CurveStyle& style, const StepLabel& label) {
    if (const Curve* curve = document().find(index(), serial))
        document().changeInBurst(index(), serial, withStyle(*curve, style), label);
}

void SheetCurves::moveCurve(Serial serial, int to) {
    if (to >= 0 && to < static_cast<int>(sheet().curves.size()))
        document().reorder(index(), serial, to, {QT_TRANSLATE_NOOP("Step", "Reorder the curves")});
}

void SheetCurves::activateNextCurve() {
    const std::vector<Serial>& serials = document().serials(index());
    if (!serials.empty())
        activate(serials[static_cast<std::size_t>(sheet().view.activeCurve + 1) % serials.size()]);
}

void SheetCurves::usePointsIn(SheetIndex other) {
    const Curve* curve = activeCurve();
    if (!curve || other == index())
        return;
    const int last = static_cast<int>(document().sheet(other).curves.size());
    if (document().add(other, last, converted(*curve, other), {QT_TRANSLATE_NOOP("Step", "Use the points of a tab")}))
        document().setActiveSheet(other);
}

void SheetCurves::setActiveCurveShown(bool isShown) {
    document().setCurveShown(index(), activeSerial(), isShown);
}

void SheetCurves::clear() {
    document().endGesture();
    if (sheet().curves.empty())
        return;
    QUndoStack& history = document().history(index());
    history.beginMacro(stored({QT_TRANSLATE_NOOP("Step", "Clear the canvas")}));
    for (const Serial serial : std::vector<Serial>(document().serials(index())))
        deleteCurve(serial);
    history.endMacro();
}

} // namespace kriva::ui
