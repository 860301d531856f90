#pragma once

#include "ui/canvas/rulers/ruler.h"

namespace kriva::ui {

class CanvasView;

/// A canvas with rulers along its top and its left side, which can be hidden.
class RuledCanvas : public QWidget {
    Q_OBJECT
  public:
    /// Takes the canvas as its child.
    explicit RuledCanvas(CanvasView* canvas, QWidget* parent = nullptr);

    void setRulersShown(bool areShown);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    Ruler* above_;
    Ruler* atLeft_;
    QWidget* corner_;
};

} // namespace kriva::ui
