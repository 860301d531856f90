#include "ui/panels/plots/plot_view.h"

#include "ui/canvas/qt_geometry.h"
#include "ui/figures/caption_text.h"

#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace kriva::ui {
namespace {

constexpr double kWheelStep = 1.15; ///< for a notch of the wheel
constexpr double kKeyStep = 0.01;   ///< of the axis, for an arrow key
constexpr int kDark = 128;          ///< lightness below which paper is dark

/// A value that much farther along its axis.
double moved(const PlotAxis& axis, double value, double way) {
    return fromLength(axis, toLength(axis, value) + way);
}

} // namespace

PlotView::PlotView(QWidget* parent)
    : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

QSize PlotView::sizeHint() const {
    return {360, 220};
}

QSize PlotView::minimumSizeHint() const {
    return {180, 110};
}

void PlotView::setPlot(Plot plot) {
    if (plot.x.variable != plot_.x.variable || plot.x.isLogarithmic != plot_.x.isLogarithmic)
        range_.reset();
    plot_ = std::move(plot);
    update();
}

Plot PlotView::shownPlot() const {
    if (!range_)
        return plot_;
    Plot shown = plot_;
    std::tie(shown.x.low, shown.x.high) = *range_;
    return withYFitted(std::move(shown));
}

void PlotView::setCrosshair(std::optional<double> x) {
    crosshair_ = x;
    update();
}

void PlotView::moveCrosshair(std::optional<double> x) {
    if (crosshair_ == x)
        return;
    setCrosshair(x);
    Q_EMIT crosshairMoved(x);
}

void PlotView::setRange(std::optional<std::pair<double, double>> range) {
    range_ = range;
    update();
}

void PlotView::changeRange(std::optional<std::pair<double, double>> range) {
    setRange(range);
    Q_EMIT rangeChanged(range);
}

PlotSize PlotView::plotSize() const {
    return {width() / kPixelsPerMillimetre, height() / kPixelsPerMillimetre};
}

double PlotView::xAt(double pixel) const {
    const Plot shown = shownPlot();
    return plotX(shown, plotFrame(shown, plotSize()), pixel / kPixelsPerMillimetre);
}

void PlotView::paintEvent(QPaintEvent*) {
    Plot shown = shownPlot();
    if (crosshair_)
        shown.at = crosshair_;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    const PlotSize size = plotSize();
    Sight sight;
    sight.viewport = {
        kPixelsPerMillimetre, {size.width / 2, size.height / 2}, QSizeF(this->size()), kPixelsPerMillimetre};
    sight.theme = palette().base().color().lightness() < kDark ? Theme::dark : Theme::light;
    sight.texts = textSource();
    sight.devicePixelRatio = devicePixelRatioF();
    sight.hasAxes = false;
    FigureItem item;
    item.setFigure(plotFigure({&shown, 1}, size));
    FrameLoad load;
    item.prepare(sight, pictures_, load);
    item.draw(painter, rect());
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(palette().color(QPalette::Highlight));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void PlotView::mousePressEvent(QMouseEvent* event) {
    pressed_ = event->position().x();
}

void PlotView::mouseMoveEvent(QMouseEvent* event) {
    const double pixel = event->position().x();
    if (event->buttons().testFlag(Qt::LeftButton)) {
        const PlotAxis x = shownPlot().x;
        const double way = toLength(x, xAt(pressed_)) - toLength(x, xAt(pixel));
        if (!plot_.isToScale)
            changeRange(std::pair(moved(x, x.low, way), moved(x, x.high, way)));
        pressed_ = pixel;
    }
    const double at = xAt(pixel);
    const PlotAxis x = shownPlot().x;
    moveCrosshair(x.low <= at && at <= x.high && !plot_.isToScale ? std::optional(lookedAt(plot_, at)) : std::nullopt);
}

void PlotView::mouseDoubleClickEvent(QMouseEvent*) {
    changeRange(std::nullopt);
}

void PlotView::leaveEvent(QEvent*) {
    moveCrosshair(std::nullopt);
}

void PlotView::wheelEvent(QWheelEvent* event) {
    constexpr double kNotch = 120;
    zoom(std::pow(kWheelStep, event->angleDelta().y() / kNotch), xAt(event->position().x()));
    event->accept();
}

void PlotView::zoom(double factor, double around) {
    const PlotAxis x = shownPlot().x;
    if (plot_.isToScale)
        return;
    const double middle = toLength(x, around);
    const auto way = [&](double end) { return (toLength(x, end) - middle) * (1 / factor - 1); };
    const std::pair range(moved(x, x.low, way(x.low)), moved(x, x.high, way(x.high)));
    constexpr double kLeastPart = 1e-6; // of the whole: beyond it numbers could not be told apart
    const double whole = toLength(x, plot_.x.high) - toLength(x, plot_.x.low);
    const double part = toLength(x, range.second) - toLength(x, range.first);
    if (part >= whole)
        changeRange(std::nullopt);
    else if (part > kLeastPart * whole)
        changeRange(range);
}

double PlotView::stepped(double from, int way) const {
    const PlotAxis x = shownPlot().x;
    double length = toLength(x, from);
    const double high = toLength(x, x.high);
    const double step = way * kKeyStep * (high - toLength(x, x.low));
    double to = from;
    // Members of a sequence may be farther apart than a step.
    do {
        length += step;
        const double at = fromLength(x, length);
        if (at < x.low || at > x.high)
            return plot_.isSequence ? to : std::clamp(at, x.low, x.high);
        to = lookedAt(plot_, at);
    } while (to == from);
    return to;
}

void PlotView::keyPressEvent(QKeyEvent* event) {
    const PlotAxis x = shownPlot().x;
    const double from = crosshair_.value_or(plot_.at.value_or((x.low + x.high) / 2));
    switch (event->key()) {
    case Qt::Key_Left:
        return moveCrosshair(stepped(from, -1));
    case Qt::Key_Right:
        return moveCrosshair(stepped(from, 1));
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoom(kWheelStep, from);
    case Qt::Key_Minus:
        return zoom(1 / kWheelStep, from);
    case Qt::Key_0:
        return changeRange(std::nullopt);
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace kriva::ui
