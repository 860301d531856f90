#include "ui/figures/drawing_painter.h"

#include "core/figure/label_placement.h"
#include "core/io/drawn_pieces.h"
#include "ui/figures/figure_ink.h"

#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>

#include <limits>
#include <set>
#include <utility>

namespace kriva::ui {
namespace {

/// A raster strokes a path as one shape, whose cost grows faster than its length: it gets so many pieces at once. Round
/// caps hide the seams.
constexpr std::size_t kPiecesOfRaster = 64;
constexpr double kLengthOfRaster = 1'000; // pixels, of a path of many points: lines that cross each other are slow
constexpr double kAnyLength = std::numeric_limits<double>::infinity();

/// Dashes have no caps to hide a seam: they are cut only where there are more points than anyone can tell apart.
constexpr std::size_t kMostWholeDashes = 2'000;

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
        for (const Stroke& s : layer.strokes)
            stroke(s);
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

    void stroke(const Stroke& stroke) {
        const RoleStyle style = styleOf(stroke, drawing_.theme);
        QPen pen = penOf(style, pointSize());
        pen.setJoinStyle(Qt::RoundJoin);
        pen.setCapStyle(style.dashes.empty() ? Qt::RoundCap : Qt::FlatCap);
        painter_.setOpacity(stroke.strength);
        const bool hasFewDashes = !style.dashes.empty() && stroke.path.points.size() <= kMostWholeDashes;
        const bool mayBeCut = isRaster_ && !hasFewDashes && stroke.strength == 1;
        const double longest = stroke.path.points.size() > kPiecesOfRaster ? kLengthOfRaster : kAnyLength;
        QPainterPath path;
        std::size_t pieces = 0;
        double length = 0;
        bool isWhole = true;
        forEachDrawnPiece(stroke.path, drawing_.page, [&](std::span<const Point> piece) {
            if (mayBeCut && (pieces == kPiecesOfRaster || length > longest)) {
                painter_.strokePath(path, pen);
                if (!style.dashes.empty()) // which go on where they were
                    pen.setDashOffset(pen.dashOffset() + path.length() / pen.widthF());
                path = QPainterPath();
                pieces = 0;
                length = 0;
                isWhole = false;
            }
            if (pieces++ == 0)
                path.moveTo(onPainter(piece.front()));
            add(path, piece);
            length += QLineF(onPainter(piece.front()), onPainter(piece.back())).length();
        });
        if (stroke.path.isClosed && isWhole)
            path.closeSubpath();
        painter_.strokePath(path, pen);
    }
    void add(QPainterPath& path, std::span<const Point> piece) const {
        if (piece.size() == 2)
            path.lineTo(onPainter(piece[1]));
        else if (piece.size() == 3)
            path.quadTo(onPainter(piece[1]), onPainter(piece[2]));
        else
            path.cubicTo(onPainter(piece[1]), onPainter(piece[2]), onPainter(piece[3]));
    }

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
