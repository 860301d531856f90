#include "ui/figures/drawing_painter.h"

#include "core/figure/label_placement.h"
#include "ui/figures/figure_ink.h"
#include "ui/figures/stroke_painter.h"

#include <QPaintEngine>
#include <QPainter>

#include <set>
#include <utility>

namespace kriva::ui {
namespace {

/// As many marks of a raster as are all painted. Of more, those in a pixel that has one already are left out: nobody
/// sees them, and each takes as long as a hundred points of a line.
constexpr std::size_t kMostWholeMarks = 2'000;

class DrawingPainter {
  public:
    DrawingPainter(QPainter& painter, const Drawing& drawing, double unit)
        : painter_(painter)
        , drawing_(drawing)
        , unit_(unit)
        , fonts_(labelFonts(pointSize()))
        , isRaster_(painter.paintEngine()->type() == QPaintEngine::Raster) {}

    void layer(const Layer& layer, const std::vector<PlacedLabel>& labels) {
        for (const Stroke& stroke : layer.strokes)
            paintStroke(painter_, stroke, drawing_.page, drawing_.theme, unit_);
        painter_.setOpacity(1);
        for (const Marks& marks : layer.marks) {
            const RoleStyle style = styleOf(marks, drawing_.theme);
            std::set<std::pair<int, int>> taken;
            for (const Point p : marks.at) {
                const QPointF at = place(p);
                const bool mayBeLeftOut = isRaster_ && marks.at.size() > kMostWholeMarks;
                if (!mayBeLeftOut || taken.emplace(qFloor(at.x()), qFloor(at.y())).second)
                    paintMark(painter_, style, at, pointSize());
            }
        }
        for (const PlacedLabel& label : labels) {
            painter_.setPen(toQt(labelColor(label.role, drawing_.theme)));
            paintLabel(painter_, label, {unit_ * label.baseline.x, unit_ * label.baseline.y}, fonts_);
        }
    }

  private:
    [[nodiscard]] double pointSize() const { return unit_ * kMillimetresPerPoint; }
    [[nodiscard]] QPointF onPainter(Point ofPage) const { return {unit_ * ofPage.x, unit_ * ofPage.y}; }
    [[nodiscard]] QPointF place(Point p) const { return onPainter(onPage(drawing_.page, p)); }

    QPainter& painter_;
    const Drawing& drawing_;
    double unit_;
    LabelFonts fonts_;
    bool isRaster_;
};

} // namespace

void paintDrawing(QPainter& painter, const Drawing& drawing, const TextSource& texts, double unit) {
    if (drawing.hasPaper)
        painter.fillRect(QRectF(0, 0, unit * drawing.page.width, unit * drawing.page.height),
                         toQt(paperColor(drawing.theme)));
    DrawingPainter on(painter, drawing, unit);
    const auto labels = placedLabels(drawing.figure, drawing.page, texts);
    for (std::size_t i = 0; i < labels.size(); ++i)
        on.layer(drawing.figure.layers[i], labels[i]);
}

} // namespace kriva::ui
