#include "ui/figures/stroke_painter.h"

#include "core/figure/role_style.h"
#include "core/geometry/simplify.h"
#include "core/io/drawing/drawn_pieces.h"
#include "ui/figures/figure_ink.h"

#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>

namespace kriva::ui {
namespace {

/// A raster strokes a path as one shape, whose cost grows faster than its length: it gets so many pieces at once. Round
/// caps hide the seams.
constexpr std::size_t kPiecesOfRaster = 64;
constexpr double kLengthOfRaster = 1'000; // pixels, of a path of many points: lines that cross each other are slow

/// A straight piece of a raster from this length on, in pixels, is painted by itself with flat ends, which Qt does ten
/// times faster, and with discs at both of them.
constexpr double kLongLine = 100;

/// Dashes have no caps to hide a seam: they are cut only where there are more points than anyone can tell apart.
constexpr std::size_t kMostWholeDashes = 2'000;

/// A polyline of more points than a raster can show is painted with fewer, so near that nobody sees it.
constexpr std::size_t kMostWholePolyline = 2'000;
constexpr double kSimplification = 0.1; // pixels

bool isPolyline(const Path& path) {
    return path.points.size() == path.degrees.size() + 1;
}

/// Strokes pieces that follow one another as one path, or on a raster as several.
class StrokePainter {
  public:
    StrokePainter(QPainter& painter, const QPen& pen, bool isLong)
        : painter_(painter)
        , pen_(pen)
        , isLong_(isLong) {}

    /// In painter units; starts where the piece before it ended.
    void add(std::span<const QPointF> piece) {
        if (path_.isEmpty())
            path_.moveTo(piece.front());
        if (piece.size() == 2)
            path_.lineTo(piece[1]);
        else if (piece.size() == 3)
            path_.quadTo(piece[1], piece[2]);
        else
            path_.cubicTo(piece[1], piece[2], piece[3]);
        ++pieces_;
        length_ += QLineF(piece.front(), piece.back()).length();
    }
    void addInParts(std::span<const QPointF> piece) {
        if (piece.size() == 2 && pen_.style() == Qt::SolidLine && QLineF(piece[0], piece[1]).length() >= kLongLine) {
            flush();
            paintLine(piece[0], piece[1]);
            return;
        }
        if (pieces_ == kPiecesOfRaster || (isLong_ && length_ > kLengthOfRaster))
            flush();
        add(piece);
    }
    void close() {
        if (isWhole_)
            path_.closeSubpath();
    }
    /// What was added and is not painted yet.
    void flush() {
        painter_.strokePath(path_, pen_);
        if (pen_.style() != Qt::SolidLine) // dashes go on where they were
            pen_.setDashOffset(pen_.dashOffset() + path_.length() / pen_.widthF());
        path_ = QPainterPath();
        pieces_ = 0;
        length_ = 0;
        isWhole_ = false;
    }

  private:
    void paintLine(QPointF from, QPointF to) {
        QPen flat = pen_;
        flat.setCapStyle(Qt::FlatCap);
        painter_.setPen(flat);
        painter_.drawLine(from, to);
        painter_.setPen(pen_);
        painter_.drawPoint(from);
        painter_.drawPoint(to);
    }

    QPainter& painter_;
    QPen pen_;
    bool isLong_;
    QPainterPath path_;
    std::size_t pieces_ = 0; ///< of path_, as length_
    double length_ = 0;
    bool isWhole_ = true; ///< nothing is painted yet
};

} // namespace

void paintStroke(QPainter& painter, const Stroke& stroke, const Page& page, Theme theme, double unit) {
    const RoleStyle style = styleOf(stroke, theme);
    const bool isRaster = painter.paintEngine()->type() == QPaintEngine::Raster;
    const std::size_t size = stroke.path.points.size();
    const bool hasFewDashes = !style.dashes.empty() && size <= kMostWholeDashes;
    const bool mayBeCut = isRaster && !hasFewDashes && stroke.strength == 1;
    QPen pen = penOf(style, unit * kMillimetresPerPoint);
    pen.setJoinStyle(Qt::RoundJoin);
    pen.setCapStyle(style.dashes.empty() ? Qt::RoundCap : Qt::FlatCap);
    painter.setOpacity(stroke.strength);
    StrokePainter strokes(painter, pen, size > kPiecesOfRaster);
    const auto add = [&](std::span<const Point> piece) {
        std::array<QPointF, 4> places;
        std::ranges::transform(piece, places.begin(), [&](Point p) { return QPointF(unit * p.x, unit * p.y); });
        const auto inPixels = std::span<const QPointF>(places).first(piece.size());
        mayBeCut ? strokes.addInParts(inPixels) : strokes.add(inPixels);
    };
    if (isRaster && size > kMostWholePolyline && isPolyline(stroke.path))
        forEachDrawnPiece(polyline(simplified(stroke.path.points, {kSimplification / (unit * page.mmPerUnit)})), page,
                          add);
    else
        forEachDrawnPiece(stroke.path, page, add);
    if (stroke.path.isClosed)
        strokes.close();
    strokes.flush();
}

} // namespace kriva::ui
