#include "ui/canvas/rulers/ruler.h"

#include "ui/canvas/base/grid.h"
#include "ui/figures/caption_text.h"

#include <QEvent>
#include <QPainter>

#include <cmath>
#include <limits>

namespace kriva::ui {
namespace {

// In pixels.
constexpr int kRoom = 6; // beside the numbers: for the short ticks
constexpr double kShortTick = 4;
constexpr double kNumberGap = 3;

constexpr float kTickStrength = 0.5F;

} // namespace

Ruler::Ruler(Qt::Orientation orientation, QWidget* parent)
    : QWidget(parent)
    , orientation_(orientation) {
    setObjectName(isAcross() ? QStringLiteral("rulerAbove") : QStringLiteral("rulerAtLeft"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(isAcross() ? QSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed)
                             : QSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored));
}

QSize Ruler::sizeHint() const {
    const int thickness = fontMetrics().height() + kRoom;
    return {thickness, thickness};
}

void Ruler::setMapping(const Viewport& mapping) {
    mapping_ = mapping;
    update();
}

void Ruler::setPointer(std::optional<QPointF> pixel) {
    pointer_ = pixel;
    update();
}

void Ruler::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        update(); // numbers follow the language
    QWidget::changeEvent(event);
}

double Ruler::placeOf(double coordinate) const {
    const QPointF pixel = mapping_.toPixels({coordinate, coordinate});
    return isAcross() ? pixel.x() : pixel.y();
}

void Ruler::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    paintTicks(painter);
    paintNumbers(painter);
    const int thickness = isAcross() ? height() : width();
    if (pointer_)
        paintTick(painter, isAcross() ? pointer_->x() : pointer_->y(), thickness, palette().color(QPalette::Highlight));
    painter.fillRect(isAcross() ? QRect(0, height() - 1, width(), 1) : QRect(width() - 1, 0, 1, height()),
                     palette().mid());
}

void Ruler::paintTick(QPainter& painter, double place, double length, const QColor& color) const {
    const double from = std::floor(place);
    painter.fillRect(
        isAcross() ? QRectF(from, height() - length, 1, length) : QRectF(width() - length, from, length, 1), color);
}

void Ruler::paintTicks(QPainter& painter) const {
    const Box seen = visibleBox(mapping_);
    const double low = isAcross() ? seen.xmin : seen.ymin;
    const double high = isAcross() ? seen.xmax : seen.ymax;
    QColor color = palette().color(QPalette::Text);
    color.setAlphaF(kTickStrength);
    for (const double coordinate : multiples(gridStep(mapping_), low, high))
        paintTick(painter, placeOf(coordinate), kShortTick, color);
    for (const double coordinate : multiples(numberStep(mapping_), low, high))
        paintTick(painter, placeOf(coordinate), isAcross() ? height() : width(), color);
}

void Ruler::paintNumbers(QPainter& painter) const {
    const TextSource texts = textSource();
    const Box seen = visibleBox(mapping_);
    const double step = numberStep(mapping_);
    painter.setPen(palette().color(QPalette::Text));
    if (!isAcross())
        painter.rotate(-90); // read from the right, along the ruler
    const double ascent = painter.fontMetrics().ascent();
    double freeFrom = -std::numeric_limits<double>::infinity();
    for (const double coordinate :
         multiples(step, isAcross() ? seen.xmin : seen.ymin, isAcross() ? seen.xmax : seen.ymax)) {
        const QString text = QString::fromStdString(texts.number(coordinate, decimalsOf(step)));
        // Turned round, the way up is the way of the text.
        const double start = (isAcross() ? 1 : -1) * placeOf(coordinate) + kNumberGap;
        if (start < freeFrom)
            continue;
        freeFrom = start + painter.fontMetrics().horizontalAdvance(text) + 2 * kNumberGap;
        painter.drawText(QPointF(start, ascent), text);
    }
    painter.resetTransform();
}

} // namespace kriva::ui
