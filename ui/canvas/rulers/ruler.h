#pragma once

#include "ui/canvas/base/viewport.h"

#include <QWidget>

#include <optional>

class QPainter;

namespace kriva::ui {

/// A ruler along one side of a canvas: the coordinates of what is seen there, with ticks where the grid has its lines,
/// and a mark where the pointer is.
class Ruler : public QWidget {
    Q_OBJECT
  public:
    explicit Ruler(Qt::Orientation orientation, QWidget* parent = nullptr);

    void setMapping(const Viewport& mapping);
    /// In pixels of the canvas; nothing while the pointer is elsewhere.
    void setPointer(std::optional<QPointF> pixel);
    [[nodiscard]] std::optional<QPointF> pointer() const { return pointer_; }

    [[nodiscard]] QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    [[nodiscard]] bool isAcross() const { return orientation_ == Qt::Horizontal; }
    /// Along the ruler, in pixels.
    [[nodiscard]] double placeOf(double coordinate) const;
    /// A line across the ruler, this long from its canvas side.
    void paintTick(QPainter& painter, double place, double length, const QColor& color) const;
    void paintTicks(QPainter& painter) const;
    void paintNumbers(QPainter& painter) const;

    Qt::Orientation orientation_;
    Viewport mapping_;
    std::optional<QPointF> pointer_;
};

} // namespace kriva::ui
