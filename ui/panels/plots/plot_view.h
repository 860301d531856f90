#pragma once

#include "core/figure/plot/plot_figure.h"
#include "ui/canvas/drawing/figure_item.h"

#include <QWidget>

namespace kriva::ui {

/// Draws a plot as large as it is, with a crosshair under the pointer or the arrow keys. The wheel zooms along x, a
/// drag moves along it, a double-click shows all again; y always shows what there is. Plots to scale have no crosshair,
/// and zoom along both axes.
class PlotView : public QWidget {
    Q_OBJECT
  public:
    explicit PlotView(QWidget* parent = nullptr);

    /// Another plot of the same x keeps the part that is seen.
    void setPlot(Plot plot);
    [[nodiscard]] const Plot& plot() const { return plot_; }
    /// What is on view, zoomed as it is.
    [[nodiscard]] Plot shownPlot() const;
    void setCrosshair(std::optional<double> x);
    [[nodiscard]] std::optional<double> crosshair() const { return crosshair_; }
    /// The place under the pointer, in plots to scale.
    [[nodiscard]] std::optional<Point> pointedAt() const { return pointedAt_; }
    /// Shows a part of the axes, of x alone where the plot is not to scale; nothing for all of them.
    void setPart(const std::optional<Box>& part);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

  Q_SIGNALS:
    void crosshairMoved(std::optional<double> x);
    void pointedAtMoved();
    void partChanged(const std::optional<kriva::Box>& part);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    [[nodiscard]] PlotSize plotSize() const;
    [[nodiscard]] Box frame() const { return plotFrame(plot_, plotSize()); }
    [[nodiscard]] Point placeAt(const Plot& shown, QPointF pixel) const;
    void moveCrosshair(std::optional<double> x);
    void changePart(const std::optional<Box>& part);
    void zoom(double factor, Point around);
    /// Where an arrow key goes from there, 1 for right and -1 for left.
    [[nodiscard]] double stepped(double from, int way) const;

    Plot plot_;
    std::optional<Box> part_;
    std::optional<double> crosshair_;
    std::optional<Point> pointedAt_;
    QPointF pressed_; ///< pixel of the pointer when the last part of a drag began
    MarkPictures pictures_;
};

} // namespace kriva::ui
