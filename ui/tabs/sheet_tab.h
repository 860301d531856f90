#pragma once

#include "ui/canvas/rulers/ruled_canvas.h"
#include "ui/editing/canvas_content.h"
#include "ui/editing/sheet_input.h"
#include "ui/tabs/sheet_actions.h"
#include "ui/tabs/sheet_panels.h"

namespace kriva::ui {

/// One tab: the canvas of a sheet with its dockable panels, and what works on them.
class SheetTab : public QMainWindow {
    Q_OBJECT
  public:
    /// `ui` and the threads outlive the tab.
    SheetTab(OpenDocument& document, QThreadPool& workers, SheetIndex sheet, const SheetUi& ui,
             QWidget* parent = nullptr);

    void setVisible(bool isVisible) override;

    [[nodiscard]] SheetEditor& editor() { return editor_; }
    [[nodiscard]] SheetInput& input() { return input_; }
    [[nodiscard]] CanvasView& canvas() { return input_.canvas(); }
    [[nodiscard]] RuledCanvas& ruledCanvas() { return *ruled_; }
    [[nodiscard]] SheetPanels& panels() { return panels_; }
    [[nodiscard]] const SheetActions& actions() const { return actions_; }

  protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void retranslateUi();

    SheetEditor editor_;
    SheetRelations relations_{editor_};
    SheetInput input_;
    CanvasContent content_;
    RuledCanvas* ruled_;
    SheetPanels panels_;
    SheetActions actions_;
};

} // namespace kriva::ui
