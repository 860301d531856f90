#pragma once

#include "ui/canvas/canvas_client.h"
#include "ui/canvas/canvas_view.h"
#include "ui/canvas/rulers/ruled_canvas.h"
#include "ui/editing/canvas_content.h"
#include "ui/editing/sheet_drag.h"
#include "ui/editing/sheet_editor.h"
#include "ui/tabs/sheet_actions.h"
#include "ui/tabs/sheet_panels.h"

namespace kriva::ui {

/// One tab: the canvas of a sheet with its dockable panels. It carries out what a person does on the canvas.
class SheetTab : public QMainWindow, private CanvasClient {
    Q_OBJECT
  public:
    /// `ui` and the threads outlive the tab.
    SheetTab(OpenDocument& document, QThreadPool& workers, SheetIndex sheet, const SheetUi& ui,
             QWidget* parent = nullptr);

    void setVisible(bool isVisible) override;

    [[nodiscard]] CanvasView& canvas() { return *canvas_; }
    [[nodiscard]] SheetEditor& editor() { return editor_; }
    [[nodiscard]] SheetPanels& panels() { return panels_; }
    void setRulersShown(bool areShown) { ruled_->setRulersShown(areShown); }
    /// Whether points that are dragged or added snap.
    void setSnapping(bool isSnapping) { isSnapping_ = isSnapping; }
    [[nodiscard]] const SheetActions& actions() const { return actions_; }

    /// Inserts a point where the context menu was asked for, if that was on a curve; else behind the selected point.
    void insertPointHere();
    /// A context menu opens: what is under it is selected or made active, so that the actions are about it.
    void beginMenu(const Hit& under, Point at);
    void endMenu() { menuPlace_.reset(); }

  Q_SIGNALS:
    /// A text for the status row about what lies under the pointer; empty where there is nothing to say.
    void hintChanged(const QString& hint);
    /// A text for the status row about what just happened.
    void told(const QString& text);

  protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    // What the canvas asks for.
    void addPoint(Point at) override;
    void addPointOn(GripRef grip, Point at) override;
    void insertPoint(Serial curve, Point at) override;
    void insertPointBehindSelected() override;
    void removePoint(GripRef grip) override;
    void removeSelected(Removal removal) override;
    void retractHandle(GripRef handle) override;
    void select(Selection selection) override;
    void activateCurve(Serial curve) override;
    void explain(const MarkPlace& mark) override;
    void beginDrag(GripRef grip) override;
    void beginAddDrag(Point at) override;
    void beginInsertDrag(Serial curve, Point at) override;
    void beginCurveDrag(Serial curve, Point at) override;
    void drag(Vector by, const DragKeys& keys) override;
    void endDrag() override;
    void cancelDrag() override;
    void nudge(Vector by) override { editor_.nudge(by); }
    void hover(const Hit& under, Point at, Qt::KeyboardModifiers modifiers) override;

    void retranslateUi();
    /// To where a new point comes that is asked for at `at`.
    [[nodiscard]] Point snapped(Point at) const;
    [[nodiscard]] std::optional<Snap> snapOfDrag(Vector by, Qt::KeyboardModifiers modifiers);

    SheetEditor editor_;
    SheetDrag drag_{editor_};
    SheetRelations relations_{editor_};
    CanvasView* canvas_;
    CanvasContent content_;
    RuledCanvas* ruled_;
    SheetPanels panels_;
    bool isSnapping_ = false;
    /// Shift switches snapping off only when it is pressed during a drag; before, it added to the selection.
    bool mayShiftSwitch_ = false;
    SheetActions actions_;
    std::optional<CurvePlace> menuPlace_; ///< of the context menu that is open
};

} // namespace kriva::ui
