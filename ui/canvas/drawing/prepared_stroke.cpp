#include "ui/canvas/drawing/prepared_stroke.h"

#include "ui/canvas/qt_geometry.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>

namespace kriva::ui {
namespace {

// In device pixels. QPainter is fast with polylines up to one pixel wide. Up to three the square ends of single lines
// look like the joints that they stand in for; beyond, they would show.
constexpr double kFastWidth = 1;
constexpr double kLineWidth = 3;
// As many points of a wide pen as can be stroked with true joints while a hand drags; it strokes a long polyline as one
// shape, whose cost grows faster than its length.
constexpr qsizetype kMostJoined = 1'000;
constexpr double kMostJoinedInk = 100'000; // pixels: where lines lie over each other, a shape of them is slow
constexpr qsizetype kPointsAtOnce = 64;

/// Cuts a walk into dashes and gaps, from one line to the next.
class Dashes {
  public:
    Dashes(const QPen& pen, QList<QLineF>& lines)
        : lines_(lines)
        , left_(pen.dashPattern().front() * pen.widthF()) {
        for (const double length : pen.dashPattern())
            lengths_.append(length * pen.widthF());
    }

    void walk(const QLineF& line) {
        const double length = line.length();
        double walked = 0;
        while (walked < length) {
            const double step = std::min(left_, length - walked);
            if (index_ % 2 == 0)
                lines_.append({line.pointAt(walked / length), line.pointAt((walked + step) / length)});
            walked += step;
            left_ -= step;
            if (left_ <= 0) {
                index_ = (index_ + 1) % lengths_.size();
                left_ = lengths_[index_];
            }
        }
    }

  private:
    QList<QLineF>& lines_;
    QList<double> lengths_;
    qsizetype index_ = 0;
    double left_; ///< of the present dash or gap
};

template <class Visit>
void forEachLine(const QPolygonF& polyline, Visit visit) {
    for (qsizetype i = 1; i < polyline.size(); ++i)
        visit(QLineF(polyline[i - 1], polyline[i]));
}

[[nodiscard]] bool canBeJoined(const PreparedStroke& stroke) {
    qsizetype points = 0;
    double length = 0;
    for (const QPolygonF& polyline : stroke.polylines) {
        points += polyline.size();
        forEachLine(polyline, [&](const QLineF& line) { length += line.length(); });
    }
    return points <= kMostJoined && length * stroke.pen.widthF() <= kMostJoinedInk;
}

void paintLines(QPainter& painter, const QList<QLineF>& lines, const Box& reached) {
    qsizetype first = 0;
    const auto paintUpTo = [&](qsizetype end) {
        if (end > first)
            painter.drawLines(lines.constData() + first, static_cast<int>(end - first));
        first = end + 1;
    };
    for (qsizetype i = 0; i < lines.size(); ++i)
        if (!overlap(boxOf(std::array{lines[i].p1(), lines[i].p2()}), reached))
            paintUpTo(i);
    paintUpTo(lines.size());
}

} // namespace

PreparedStroke preparedStroke(std::vector<QPolygonF> polylines, QPen pen, double devicePixelRatio) {
    PreparedStroke stroke{std::move(pen), std::move(polylines), {}};
    const double width = stroke.pen.widthF() * devicePixelRatio;
    if (width <= kFastWidth || (width > kLineWidth && canBeJoined(stroke)))
        return stroke;
    const bool isDashed = stroke.pen.style() == Qt::CustomDashLine;
    for (const QPolygonF& polyline : stroke.polylines) {
        if (isDashed)
            forEachLine(polyline,
                        [dashes = Dashes(stroke.pen, stroke.lines)](const QLineF& line) mutable { dashes.walk(line); });
        else
            forEachLine(polyline, [&](const QLineF& line) { stroke.lines.append(line); });
    }
    // Square ends fill the joints between lines; dashes keep their length.
    stroke.pen.setStyle(Qt::SolidLine);
    stroke.pen.setCapStyle(isDashed ? Qt::FlatCap : Qt::SquareCap);
    return stroke;
}

void paint(QPainter& painter, const PreparedStroke& stroke, const QRectF& seen) {
    painter.setPen(stroke.pen);
    const double reach = stroke.pen.widthF() + 1;
    const Box reached = grown(toCore(seen), reach);
    paintLines(painter, stroke.lines, reached);
    if (!stroke.lines.empty())
        return;
    const bool isDashed = stroke.pen.style() != Qt::SolidLine;
    for (const QPolygonF& polyline : stroke.polylines) {
        // Each part begins with the last line of the one before, so that the joint between them has no gap. Dashes go
        // on from one line to the next.
        const qsizetype step = isDashed ? std::max<qsizetype>(1, polyline.size()) : kPointsAtOnce;
        for (qsizetype first = 0; first + 1 < polyline.size(); first += step) {
            const qsizetype from = std::max<qsizetype>(0, first - 1);
            const qsizetype to = std::min(polyline.size(), first + step + 1);
            const std::span part(polyline.constData() + from, static_cast<std::size_t>(to - from));
            if (overlap(boxOf(part), reached))
                painter.drawPolyline(part.data(), static_cast<int>(part.size()));
        }
    }
}

} // namespace kriva::ui
