#include "ui/panels/plots/plot_view.h"

#include "ui/canvas/base/qt_geometry.h"
#include "ui/figures/caption_text.h"

#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

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
        part_.reset();
    plot_ = std::move(plot);
    update();
}

Plot PlotView::shownPlot() const {
    if (!part_)
        return plot_;
    Plot shown = plot_;
    shown.x.low = part_->xmin;
    shown.x.high = part_->xmax;
    if (!plot_.isToScale)
        return withYFitted(std::move(shown));
    shown.y.low = part_->ymin;
    shown.y.high = part_->ymax;
    return shown;
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

void PlotView::setPart(const std::optional<Box>& part) {
    part_ = part;
    update();
}

void PlotView::changePart(const std::optional<Box>& part) {
    setPart(part);
    Q_EMIT partChanged(part);
}

PlotSize PlotView::plotSize() const {
    return {width() / kPixelsPerMillimetre, height() / kPixelsPerMillimetre};
}

Point PlotView::placeAt(const Plot& shown, QPointF pixel) const {
    const PlotSize size = plotSize();
    return inPlot(shown, plotFrame(shown, size),
                  {pixel.x() / kPixelsPerMillimetre, size.height - pixel.y() / kPixelsPerMillimetre});
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
    pressed_ = event->position();
}

void PlotView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF pixel = event->position();
    if (event->buttons().testFlag(Qt::LeftButton)) {
        const Plot shown = shownPlot();
        const Point from = placeAt(shown, pressed_);
        const Point to = placeAt(shown, pixel);
        const double wayX = toLength(shown.x, from.x) - toLength(shown.x, to.x);
        const double wayY = toLength(shown.y, from.y) - toLength(shown.y, to.y);
        changePart(Box{moved(shown.x, shown.x.low, wayX), moved(shown.y, shown.y.low, wayY),
                       moved(shown.x, shown.x.high, wayX), moved(shown.y, shown.y.high, wayY)});
        pressed_ = pixel;
    }
    const Plot shown = shownPlot();
    const Point at = placeAt(shown, pixel);
    const bool isInside = shown.x.low <= at.x && at.x <= shown.x.high;
    if (!plot_.isToScale)
        return moveCrosshair(isInside ? std::optional(lookedAt(plot_, at.x)) : std::nullopt);
    pointedAt_ = isInside && shown.y.low <= at.y && at.y <= shown.y.high ? std::optional(at) : std::nullopt;
    Q_EMIT pointedAtMoved();
}

void PlotView::mouseDoubleClickEvent(QMouseEvent*) {
    changePart(std::nullopt);
}

void PlotView::leaveEvent(QEvent*) {
    moveCrosshair(std::nullopt);
    if (std::exchange(pointedAt_, std::nullopt))
        Q_EMIT pointedAtMoved();
}

void PlotView::wheelEvent(QWheelEvent* event) {
    constexpr double kNotch = 120;
    zoom(std::pow(kWheelStep, event->angleDelta().y() / kNotch), placeAt(shownPlot(), event->position()));
    event->accept();
}

void PlotView::zoom(double factor, Point around) {
    const Plot shown = shownPlot();
    const auto nearer = [&](const PlotAxis& axis, double end, double middle) {
        return moved(axis, end, (toLength(axis, end) - toLength(axis, middle)) * (1 / factor - 1));
    };
    const Box part{nearer(shown.x, shown.x.low, around.x), nearer(shown.y, shown.y.low, around.y),
                   nearer(shown.x, shown.x.high, around.x), nearer(shown.y, shown.y.high, around.y)};
    constexpr double kLeastPart = 1e-6; // of the whole: beyond it numbers could not be told apart
    const double whole = toLength(shown.x, plot_.x.high) - toLength(shown.x, plot_.x.low);
    const double seen = toLength(shown.x, part.xmax) - toLength(shown.x, part.xmin);
    if (seen >= whole)
        changePart(std::nullopt);
    else if (seen > kLeastPart * whole)
        changePart(part);
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
    const Plot shown = shownPlot();
    const double from = crosshair_.value_or(plot_.at.value_or((shown.x.low + shown.x.high) / 2));
    const Point middle = pointedAt_.value_or(Point{from, (shown.y.low + shown.y.high) / 2});
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
        if (plot_.isToScale)
            return;
        return moveCrosshair(stepped(from, event->key() == Qt::Key_Left ? -1 : 1));
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoom(kWheelStep, middle);
    case Qt::Key_Minus:
        return zoom(1 / kWheelStep, middle);
    case Qt::Key_0:
        return changePart(std::nullopt);
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace kriva::ui
