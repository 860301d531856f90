#pragma once

#include "core/figure/plot/plot_figure.h"
#include "ui/canvas/figure_item.h"

#include <QWidget>

namespace kriva::ui {

/// Draws a plot as large as it is, with a crosshair under the pointer or the arrow keys. The wheel zooms along x, a
/// drag moves along it, a double-click shows all again; y always shows what there is.
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
    /// Shows a part of the axis x; nothing for all of it.
    void setRange(std::optional<std::pair<double, double>> range);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

  Q_SIGNALS:
    void crosshairMoved(std::optional<double> x);
    void rangeChanged(std::optional<std::pair<double, double>> range);

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
    [[nodiscard]] double xAt(double pixel) const;
    void moveCrosshair(std::optional<double> x);
    void changeRange(std::optional<std::pair<double, double>> range);
    void zoom(double factor, double around);
    /// Where an arrow key goes from there, 1 for right and -1 for left.
    [[nodiscard]] double stepped(double from, int way) const;

    Plot plot_;
    std::optional<std::pair<double, double>> range_;
    std::optional<double> crosshair_;
    double pressed_ = 0; ///< pixel of the pointer when the last part of a drag began
    MarkPictures pictures_;
};

} // namespace kriva::ui
