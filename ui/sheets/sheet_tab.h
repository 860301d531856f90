#pragma once

#include "ui/canvas/canvas_client.h"
#include "ui/canvas/canvas_view.h"
#include "ui/sheets/sheet_drag.h"
#include "ui/sheets/sheet_editor.h"
#include "ui/sheets/sheet_ui.h"

#include <QDockWidget>
#include <QMainWindow>

namespace kriva::ui {

/// One tab: the canvas of a sheet with its dockable panels. It carries out what a person does on the canvas and keeps
/// the canvas showing what the sheet editor has on view. The panels are made when the tab is first shown: a window
/// starts with one tab in sight and four to make.
class SheetTab : public QMainWindow, private CanvasClient {
    Q_OBJECT
  public:
    /// `ui` outlives the tab.
    SheetTab(OpenDocument& document, SheetIndex sheet, const SheetUi& ui, QWidget* parent = nullptr);

    void setVisible(bool isVisible) override;

    [[nodiscard]] CanvasView& canvas() { return *canvas_; }
    [[nodiscard]] SheetEditor& editor() { return editor_; }
    /// What turns this tab's panels on and off, in the order of the menu.
    [[nodiscard]] QList<QAction*> panelActions();
    void resetPanels();
    /// How the panels lie, as saveState gives it.
    [[nodiscard]] QByteArray panelLayout() const;
    /// A layout from panelLayout; where it is none, the panels stay where they are.
    void setPanelLayout(const QByteArray& layout);

  Q_SIGNALS:
    /// A text for the status row about what lies under the pointer; empty where there is nothing to say.
    void hintChanged(const QString& hint);
    /// A text for the status row about what just happened.
    void told(const QString& text);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    // What the canvas asks for.
    void addPoint(Point at) override;
    void addPointOn(GripRef grip, Point at) override;
    void insertPoint(Serial curve, Point at) override;
    void removePoint(GripRef grip) override;
    void removeSelected(Removal removal) override;
    void select(Selection selection) override;
    void activateCurve(Serial curve) override;
    void beginDrag(GripRef grip) override;
    void beginAddDrag(Point at) override;
    void beginCurveDrag(Serial curve, Point at) override;
    void drag(Vector by, Qt::KeyboardModifiers modifiers) override;
    void endDrag() override;
    void cancelDrag() override;
    void nudge(Vector by) override;
    void hover(const Hit& under, Point at, Qt::KeyboardModifiers modifiers) override;

    void makePanels();
    void fillPanels();
    void addPanel(const char* name, const char* title, QWidget* panel, Qt::DockWidgetArea area);
    void retranslateUi();
    void retranslatePanels();
    [[nodiscard]] CanvasCurve canvasCurve(Serial serial) const;
    void showAllCurves();
    /// 100 % is the size of the page at 96 dpi. A page grows with its curves, but not under the pointer: only a new
    /// document sets the scale.
    void followPage();
    void updateCurve(Serial serial);

    struct Panel {
        QDockWidget* dock;
        const char* title;
        Qt::DockWidgetArea area;
    };

    SheetEditor editor_;
    SheetDrag drag_{editor_};
    CanvasView* canvas_;
    const SheetUi& ui_;
    std::vector<Panel> panels_;
    QByteArray firstLayout_;
    QByteArray layout_; ///< for the panels once they are made
};

} // namespace kriva::ui
