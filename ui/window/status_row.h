#pragma once

#include "core/geometry/point.h"

#include <QLabel>
#include <QStatusBar>

#include <optional>

namespace kriva::ui {

/// The status bar: a hint, the pointer's coordinates, the zoom.
class StatusRow : public QStatusBar {
    Q_OBJECT
  public:
    explicit StatusRow(QWidget* parent = nullptr);

    /// What a person can do next.
    void showHint(const QString& hint);
    /// What just happened: it stays until something else happens or the pointer moves.
    void tell(const QString& text);
    /// The next thing happens.
    void endTelling();
    void showPointer(Point at);
    /// The pointer is on no canvas.
    void forgetPointer();
    void showZoom(double percent);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void retranslateUi();

    QLabel* hint_;
    QLabel* pointer_;
    QLabel* zoom_;
    std::optional<Point> at_; ///< nothing until the pointer was on a canvas
    bool isTelling_ = false;
    double percent_ = 100;
};

} // namespace kriva::ui
