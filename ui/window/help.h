#pragma once

#include <QObject>

namespace kriva::ui {

class Actions;
class MainWindow;

/// What the Help menu does, and the line that comes with an example: what to look at.
class Help : public QObject {
    Q_OBJECT
  public:
    /// Both outlive this, which is the window's child. The window has its tabs by now.
    Help(MainWindow& window, const Actions& actions);

  Q_SIGNALS:
    /// A text for the status row about what was just opened.
    void told(const QString& text);

  private:
    void showShortcuts();
    void showAbout();
    void showExample(const QString& resource);
    void leaveExample();

    MainWindow& window_;
};

} // namespace kriva::ui
