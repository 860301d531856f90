#include "ui/figures/figure_preview.h"

#include "ui/figures/caption_text.h"
#include "ui/figures/drawing_painter.h"

#include <QPainter>

#include <algorithm>
#include <utility>

namespace kriva::ui {
namespace {

constexpr double kRoomAround = 12; // px
constexpr int kChecker = 8;        // px, of the squares that stand for no paper

/// What picture programs show behind what is transparent.
void paintCheckers(QPainter& painter, const QRectF& page, const QPalette& palette) {
    painter.fillRect(page, palette.base());
    painter.setClipRect(page);
    for (int row = 0; row * kChecker < page.height(); ++row)
        for (int column = row % 2; column * kChecker < page.width(); column += 2)
            painter.fillRect(QRectF(page.x() + column * kChecker, page.y() + row * kChecker, kChecker, kChecker),
                             palette.alternateBase());
    painter.setClipping(false);
}

} // namespace

FigurePreview::FigurePreview(QWidget* parent)
    : QWidget(parent) {
    setMinimumSize(240, 240);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void FigurePreview::setDrawing(Drawing drawing) {
    drawing_ = std::move(drawing);
    update();
}

void FigurePreview::paintEvent(QPaintEvent*) {
    const Page& page = drawing_.page;
    if (page.width <= 0 || page.height <= 0)
        return;
    const double unit = std::min((width() - 2 * kRoomAround) / page.width, (height() - 2 * kRoomAround) / page.height);
    const QSizeF size(unit * page.width, unit * page.height);
    const QRectF place((width() - size.width()) / 2, (height() - size.height()) / 2, size.width(), size.height());
    QPainter painter(this);
    if (!drawing_.hasPaper)
        paintCheckers(painter, place, palette());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.translate(place.topLeft());
    paintDrawing(painter, drawing_, textSource(), unit);
    painter.restore();
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(place);
}

} // namespace kriva::ui
