#pragma once

#include "core/io/drawing/drawing.h"

#include <QWidget>

namespace kriva::ui {

/// A drawing as its file will show it, as large as there is room.
class FigurePreview : public QWidget {
    Q_OBJECT
  public:
    explicit FigurePreview(QWidget* parent = nullptr);

    void setDrawing(Drawing drawing);
    [[nodiscard]] const Drawing& drawing() const { return drawing_; }

    [[nodiscard]] QSize sizeHint() const override { return {480, 420}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    Drawing drawing_;
};

} // namespace kriva::ui
