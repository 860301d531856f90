#pragma once

#include "core/curve/file_error.h"
#include "ui/document/serial_document.h"
#include "ui/document/step_label.h"
#include "ui/document/swap_curves.h"

#include <QObject>
#include <QTimer>
#include <QUndoGroup>
#include <QUndoStack>

#include <utility>

namespace kriva::ui {

/// The document of a window: its value, the serials of its curves, a history for each sheet, and signals that tell
/// what changed. Who listens pulls the value; nobody answers.
class OpenDocument : public QObject, private SerialDocument {
    Q_OBJECT
  public:
    explicit OpenDocument(QObject* parent = nullptr);
    ~OpenDocument() override;

    /// The present value, a running gesture's preview included.
    using SerialDocument::activeCurve;
    using SerialDocument::find;
    using SerialDocument::indexOf;
    using SerialDocument::serials;
    using SerialDocument::sheet;
    using SerialDocument::snapshot;
    using SerialDocument::value;

    /// Replaces everything: histories are cleared, and the new value counts as saved.
    void replace(Document document);
    [[nodiscard]] bool isModified() const;
    void markSaved();
    /// The present value is in no file: it counts as modified until it is saved, whatever is undone.
    void markUnsaved();

    // Steps. Each ends a running gesture first, and is refused (with a signal) where the value would be beyond the
    // limits of the model. A change to the present value is no step.
    bool change(SheetIndex sheet, Serial serial, Curve curve, const StepLabel& label);
    /// Gives the new curve's serial, nothing where it is refused. The new curve becomes the active one.
    std::optional<Serial> add(SheetIndex sheet, int index, Curve curve, const StepLabel& label);
    /// Two curves in place of one, in one step; the first becomes the active one.
    bool divide(SheetIndex sheet, Serial serial, Curve first, Curve second, const StepLabel& label);
    /// Above the others, in one step; the last becomes the active one.
    bool addAll(SheetIndex sheet, std::vector<Curve> curves, const StepLabel& label);
    void remove(SheetIndex sheet, Serial serial, const StepLabel& label);
    void reorder(SheetIndex sheet, Serial serial, int index, const StepLabel& label);

    // A gesture shows previews and becomes one step when it ends, or none where nothing differs from its beginning.
    void beginGesture(SheetIndex sheet, Serial serial, const StepLabel& label);
    /// A gesture that draws a new curve: it becomes the active one, and is gone again where the gesture is cancelled.
    /// Gives its serial, nothing where it is refused.
    std::optional<Serial> beginGestureWithNew(SheetIndex sheet, int index, Curve curve, const StepLabel& label);
    void preview(Curve curve);
    void endGesture();
    void cancelGesture();
    [[nodiscard]] bool hasGesture() const { return gesture_.has_value(); }
    /// The value at the beginning of the running gesture.
    [[nodiscard]] const Curve& gestureStart() const;
    /// A preview of a gesture that ends by itself once nothing more of its kind comes: keys held down, typing.
    void changeInBurst(SheetIndex sheet, Serial serial, Curve curve, const StepLabel& label);

    // View state: saved, never undone, never a modification.
    void setActiveSheet(SheetIndex sheet);
    void setActiveCurve(SheetIndex sheet, Serial serial);
    void setCurveShown(SheetIndex sheet, Serial serial, bool isShown);
    void setLayerShown(SheetIndex sheet, std::string_view layer, bool isShown);
    void setViewNumbers(SheetIndex sheet, const ViewSetting& setting, std::vector<double> numbers);
    /// Tells nobody: nothing looks different.
    void setExported(SheetIndex sheet, const FigureFileOptions& options) { view(sheet).exported = options; }

    [[nodiscard]] QUndoStack& history(SheetIndex sheet) { return *histories_[sheet]; }
    [[nodiscard]] QUndoGroup& histories() { return group_; }
    /// Ends a running gesture, then steps back or forth in the shown sheet's history.
    void undo();
    void redo();
    /// To the state after the first `step` steps of a sheet's history.
    void goToStep(SheetIndex sheet, int step);

  Q_SIGNALS:
    /// The value of one curve, or how it is shown.
    void curveChanged(kriva::SheetIndex sheet, kriva::ui::Serial serial);
    /// Curves came, went or changed places.
    void curvesChanged(kriva::SheetIndex sheet);
    /// Which curve is active, or which layers are shown and how.
    void viewChanged(kriva::SheetIndex sheet);
    void activeSheetChanged(kriva::SheetIndex sheet);
    void replaced();
    void modifiedChanged(bool isModified);
    /// A step would have been beyond the limits of the model; nothing changed.
    void refused(const kriva::FileError& error);

  private:
    friend class SwapCurves;
    struct Gesture {
        SheetIndex sheet;
        Serial serial;
        StepLabel label;
        std::optional<Curve> start = {}; ///< taken out by the first preview: until then, the present value
        bool isNew = false;              ///< the curve was not there before
        bool isBurst = false;
    };

    /// As SerialDocument does, told once for all of them; gives what takes it back.
    std::vector<CurveExchange> exchange(SheetIndex sheet, std::vector<CurveExchange> others);
    void push(SheetIndex sheet, std::vector<CurveExchange> others, const StepLabel& label);
    /// Whether it may stand in a sheet with these curves, in place of one of them or besides; tells where not.
    bool isWithinLimits(const Sheet& present, std::optional<int> replacedIndex, const Curve& curve);
    void tellModified();

    std::optional<Document> saved_ = Document(); ///< nothing where no file has what the document began with
    bool wasModified_ = false;
    std::array<QUndoStack*, kSheetCount> histories_;
    QUndoGroup group_;
    std::optional<Gesture> gesture_;
    QTimer burstEnd_;
};

} // namespace kriva::ui
