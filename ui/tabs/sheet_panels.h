#pragma once

#include "core/figure/style/figure_options.h"
#include "ui/editing/results/sheet_relations.h"
#include "ui/editing/sheet_editor.h"
#include "ui/tabs/panel_layout.h"
#include "ui/tabs/sheet_ui.h"

namespace kriva::ui {

class GuidePanel;
struct Example;

/// The dockable panels of a tab. Docks are made when the tab is first shown, and what is in them when they are: a
/// window starts with one tab and few panels in sight.
class SheetPanels {
  public:
    /// All of them outlive this.
    SheetPanels(QMainWindow& tab, SheetEditor& editor, const SheetRelations& relations, const SheetUi& ui);
    ~SheetPanels();
    SheetPanels(const SheetPanels&) = delete;
    SheetPanels& operator=(const SheetPanels&) = delete;

    /// Where that has not been done.
    void make();
    /// The tab is in sight and has its size: only now docks keep the room that they are given. Where that has not been
    /// done.
    void layOut();
    [[nodiscard]] PanelLayout& layout() { return layout_; }
    /// What turns the panels on and off, in the order of the menu.
    [[nodiscard]] QList<QAction*> actions();
    /// Brings a panel to the front and gives it the focus; `name` is that of its dock.
    void show(const char* name);
    /// Brings the tables to the front and chooses the point that is marked there.
    void explain(Point mark);
    /// Lets the name of the active curve be typed in the panel of curves, which comes into sight.
    void beginRenaming();
    /// The same with the guide, and gives it room to be read.
    void showGuide();
    /// What the guide says about the example on show; null where none is.
    void setExample(const Example* example);
    void retranslateUi();

  private:
    struct Panel {
        QDockWidget* dock;
        const char* title; ///< marked with QT_TRANSLATE_NOOP("SheetPanels", ...)
    };
    struct NewPanel {
        const char* name; ///< of its dock
        const char* title;
        std::function<QWidget*()> make;
    };
    void fill();
    static void retitle(const Panel& panel, const char* sheetTitle);
    [[nodiscard]] QWidget* properties() const;
    [[nodiscard]] QWidget* plots();
    [[nodiscard]] QWidget* guide();
    [[nodiscard]] QDockWidget* dockOf(const char* name) const;
    QDockWidget* bringToFront(const char* name);
    /// One below what the area has; they lie behind the first of them.
    void add(Qt::DockWidgetArea area, std::initializer_list<NewPanel> group);

    QMainWindow& tab_;
    SheetEditor& editor_;
    const SheetRelations& relations_;
    const SheetUi& ui_;
    std::vector<Panel> panels_;
    GuidePanel* guide_ = nullptr;
    const Example* example_ = nullptr;
    FigureFileOptions exportedPlots_{.drawing = {.margin = 0}}; ///< how the last ones were
    PanelLayout layout_{tab_};
};

} // namespace kriva::ui
