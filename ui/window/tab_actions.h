#pragma once

#include "ui/export/figure_export.h"

#include <QObject>

namespace kriva::ui {

class Actions;
class MainWindow;
class Menus;
class Preferences;
class SheetEditor;

/// What goes from the shown tab to clipboard, files and other tabs, and what holds for all tabs: connects these actions
/// to the shown tab, and lets them show what can be done there.
class TabActions : public QObject {
    Q_OBJECT
  public:
    /// All of them outlive this, which is the window's child. The window has its tabs by now.
    TabActions(MainWindow& window, const Actions& actions, Menus& menus, Preferences& preferences);

    bool event(QEvent* event) override;

  Q_SIGNALS:
    /// A text for the status row about what just happened.
    void told(const QString& text);

  private:
    void follow();
    void connectOutlets();
    void connectCurve();
    void connectCanvas();
    void followCurve();
    void setSnapping(bool isSnapping);
    void setRulersShown(bool areShown);
    [[nodiscard]] SheetEditor& editor() const;

    MainWindow& window_;
    const Actions& actions_;
    Menus& menus_;
    Preferences& preferences_;
    FigureExport export_;
};

} // namespace kriva::ui
