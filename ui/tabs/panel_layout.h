#pragma once

#include <QDockWidget>
#include <QMainWindow>

#include <vector>

namespace kriva::ui {

/// How the panels of a tab lie, which is kept while the tab is not shown.
class PanelLayout {
  public:
    /// The tab outlives this.
    explicit PanelLayout(QMainWindow& tab)
        : tab_(tab) {}

    /// A panel of the tab.
    void add(QDockWidget* dock) { docks_.push_back(dock); }
    /// All panels are there, and the tab has its size: only now docks keep the room that they are given. What was
    /// restored before takes effect.
    void begin();
    [[nodiscard]] bool hasBegun() const { return !first_.isEmpty(); }
    /// The tab comes into sight or goes out of it. Panels that float are windows of their own and go with it.
    void setTabShown(bool isShown);

    /// As QMainWindow::saveState() gives it.
    [[nodiscard]] QByteArray state() const;
    /// Where it is no state, the panels stay where they are.
    void restore(const QByteArray& state);
    /// As it was in the beginning.
    void reset() { restore(first_); }

  private:
    void hideFloating();

    QMainWindow& tab_;
    std::vector<QDockWidget*> docks_;
    QByteArray first_;
    QByteArray state_; ///< for the panels once they are made, or shown again
    bool isTabShown_ = true;
    std::vector<QDockWidget*> hiddenWithTab_;
};

} // namespace kriva::ui
