#include "ui/panels/guide/guide_figure.h"

#include "core/document/sheet_figure.h"
#include "ui/base/examples.h"
#include "ui/canvas/drawing/figure_item.h"
#include "ui/figures/caption_text.h"

#include <QFile>
#include <QPainter>

#include <algorithm>

namespace kriva::ui {
namespace {

constexpr double kMargin = 24;         // pixels: room for marks and labels
constexpr double kLargestHeight = 0.8; // of the width, so that text beside the picture stays in sight

[[nodiscard]] QSize sizeOf(const Box& box, int width) {
    const double inner = std::max(1.0, width - 2 * kMargin);
    const double boxWidth = std::max(box.xmax - box.xmin, 1e-9);
    const double height = inner * (box.ymax - box.ymin) / boxWidth + 2 * kMargin;
    return {width, static_cast<int>(std::min(height, kLargestHeight * width))};
}

} // namespace

QImage guideFigure(const QString& name, const GuideFigureLook& look) {
    const QString resource = QStringLiteral(":/guide/figures/%1.kriva").arg(name);
    if (!QFile::exists(resource))
        return {};
    const Document document = exampleDocument(resource);
    Figure figure = figureOf(document.sheets[document.active], document.active);
    const Box box = boxOf(figure);
    const QSize size = sizeOf(box, look.width);
    Sight sight;
    sight.theme = look.theme;
    sight.texts = textSource();
    sight.devicePixelRatio = look.devicePixelRatio;
    sight.hasAxes = false;
    sight.viewport.size = size;
    sight.viewport = fitted(sight.viewport, box, kMargin);

    FigureItem item;
    item.setFigure(std::move(figure));
    MarkPictures marks;
    FrameLoad load;
    item.prepare(sight, marks, load);
    QImage image(size * look.devicePixelRatio, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(look.devicePixelRatio);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    item.draw(painter, sight.rectangle());
    return image;
}

} // namespace kriva::ui
