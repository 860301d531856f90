#pragma once

#include "ui/document/step_label.h"
#include "ui/editing/sheet/shown_sheet.h"

namespace kriva::ui {

/// The curves of a sheet of the open document, which this makes, changes and removes as wholes.
class SheetCurves : public ShownSheet {
    Q_OBJECT
  public:
    using ShownSheet::ShownSheet;

    // The active curve. `label` is marked with QT_TRANSLATE_NOOP("Step", ...).
    void change(Curve value, const StepLabel& label);
    /// As change, but steps of the same kind that follow each other closely become one.
    void changeInBurst(Curve value, const StepLabel& label);
    /// Two curves in place of the active one.
    void divide(Curve first, Curve second, const StepLabel& label);
    void reverse();

    // Any curve.
    /// False where it is refused.
    bool newCurve();
    /// The same, and what a person draws next is drawn there.
    void beginCurve();
    /// Above the others; false where it is refused.
    bool addCurve(Curve curve, const StepLabel& label);
    /// In one step; false where they are refused.
    bool addCurves(std::vector<Curve> curves, const StepLabel& label);
    void duplicateCurve(Serial serial);
    void deleteCurve(Serial serial);
    void deleteCurve(Serial serial, const StepLabel& label);
    void renameCurve(Serial serial, const QString& name);
    /// Steps of the same kind that follow each other closely become one.
    void styleCurve(Serial serial, const CurveStyle& style, const StepLabel& label);
    void moveCurve(Serial serial, int to);
    void activateNextCurve();
    /// The active curve's points as a new curve of another sheet, a step of that sheet, which is then shown.
    void usePointsIn(SheetIndex other);
    void setActiveCurveShown(bool isShown);
    /// Deletes all curves in one step.
    void clear();
    /// The same, to draw anew.
    void beginAnew();

  Q_SIGNALS:
    /// Room was made for a curve that is drawn next.
    void drawingBegun();
};

} // namespace kriva::ui
