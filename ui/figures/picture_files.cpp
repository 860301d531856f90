#include "ui/figures/picture_files.h"

#include "ui/figures/drawing_painter.h"
#include "ui/figures/figure_ink.h"
#include "ui/figures/png_writer.h"

#include <QBuffer>
#include <QDateTime>
#include <QPainter>
#include <QPdfWriter>

#include <algorithm>
#include <cmath>

namespace kriva::ui {
namespace {

constexpr double kInchesPerMetre = 1 / 0.0254;
constexpr int kRowsAround =
    16; // of a part of a PNG, above and below it: Qt is less exact at the edges of what it paints
constexpr int kPdfResolution = 7200; // dots per inch, what Qt counts a page in: 0.0035 mm

/// Puts the time that SOURCE_DATE_EPOCH gives in place of the present one, which is as long.
void setDate(QByteArray& pdf) {
    bool isGiven = false;
    const qint64 seconds = qEnvironmentVariable("SOURCE_DATE_EPOCH").toLongLong(&isGiven);
    const QByteArray key = "/CreationDate (D:";
    const qsizetype at = pdf.indexOf(key);
    if (!isGiven || at < 0)
        return;
    const qsizetype start = at + key.size();
    const qsizetype length = pdf.indexOf(')', start) - start;
    const QString given = QDateTime::fromSecsSinceEpoch(seconds, Qt::UTC).toString(QStringLiteral("yyyyMMddHHmmss"));
    const QByteArray zone = length == given.size() + 1 ? "Z" : "+00'00'"; // whichever Qt wrote
    pdf.replace(start, length, given.toLatin1() + zone);
}

} // namespace

QSize pixelSize(const Page& page, int dpi) {
    const auto pixels = [dpi](double millimetres) {
        return std::max(1, static_cast<int>(std::lround(millimetres / kMillimetresPerInch * dpi)));
    };
    return {pixels(page.width), pixels(page.height)};
}

QByteArray writePng(const Drawing& drawing, const TextSource& texts, int dpi, int pixelsAtOnce) {
    const QSize size = pixelSize(drawing.page, dpi);
    PngWriter png(size, drawing.hasPaper ? PngWriter::Ground::paper : PngWriter::Ground::transparent,
                  qRound(dpi * kInchesPerMetre));
    const int rowsOfPart = std::min(size.height(), std::max(1, pixelsAtOnce / size.width()));
    QImage part(size.width(), rowsOfPart + 2 * kRowsAround,
                drawing.hasPaper ? QImage::Format_RGB32 : QImage::Format_ARGB32_Premultiplied);
    for (int top = 0; top < size.height(); top += rowsOfPart) {
        part.fill(drawing.hasPaper ? toQt(paperColor(drawing.theme)) : QColor(Qt::transparent));
        QPainter painter(&part);
        painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
        painter.translate(0, kRowsAround - top);
        paintDrawing(painter, drawing, texts, dpi / kMillimetresPerInch);
        painter.end();
        png.add(part, kRowsAround, std::min(rowsOfPart, size.height() - top));
    }
    return png.finish();
}

QByteArray writePdf(const Drawing& drawing, const TextSource& texts) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setCreator(QStringLiteral("Kriva"));
    writer.setTitle(QString::fromStdString(drawing.title));
    writer.setResolution(kPdfResolution);
    writer.setPageMargins({});
    writer.setPageSize(QPageSize(QSizeF(drawing.page.width, drawing.page.height), QPageSize::Millimeter, QString(),
                                 QPageSize::ExactMatch));
    QPainter painter(&writer);
    paintDrawing(painter, drawing, texts, kPdfResolution / kMillimetresPerInch);
    painter.end();
    setDate(bytes);
    return bytes;
}

} // namespace kriva::ui
