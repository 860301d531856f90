#include "ui/figures/print_drawing.h"

#include "ui/figures/drawing_painter.h"
#include "ui/figures/picture_files.h"

#include <QPainter>
#include <QPrinter>

#include <algorithm>

namespace kriva::ui {

void printDrawing(QPrinter& printer, const Drawing& drawing, const TextSource& texts) {
    const QRectF paper = printer.pageLayout().paintRect(QPageLayout::Millimeter);
    const Page& page = drawing.page;
    const double size = std::min({1.0, paper.width() / page.width, paper.height() / page.height});
    const double unit = size * printer.resolution() / kMillimetresPerInch;
    const QRect room = printer.pageLayout().paintRectPixels(printer.resolution());
    Drawing onPaper = drawing;
    onPaper.hasPaper = drawing.theme == Theme::dark; // white is what paper is
    QPainter painter(&printer);
    painter.translate((room.width() - unit * page.width) / 2, (room.height() - unit * page.height) / 2);
    paintDrawing(painter, onPaper, texts, unit);
}

} // namespace kriva::ui
