#pragma once

#include <QObject>

class QKeyEvent;
class QMainWindow;

namespace kriva::ui {

/// Shortcuts and the mnemonics of the menu bar by the place of the key, where a layout has no Latin letters: Qt finds
/// "Ctrl+Z" only among the layouts that are set up, and a keyboard may have none but a Cyrillic one.
class PhysicalShortcuts : public QObject {
    Q_OBJECT
  public:
    /// For all that has the focus in the window, which outlives this.
    explicit PhysicalShortcuts(QMainWindow& window);

    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    [[nodiscard]] bool carryOut(QObject& receiver, const QKeyEvent& event);

    QMainWindow& window_;
};

} // namespace kriva::ui
