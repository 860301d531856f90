#include "ui/canvas/drawing/prepared_stroke.h"

#include "ui/canvas/base/qt_geometry.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

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

/// Cuts a walk into dashes and gaps, from one line to the next. QPainter's own dashes move with the part that is
/// painted.
class Dashes {
  public:
    explicit Dashes(const QPen& pen)
        : left_(pen.dashPattern().front() * pen.widthF()) {
        for (const double length : pen.dashPattern())
            lengths_.append(length * pen.widthF());
    }

    /// Calls visit(QLineF piece, bool isNew) for each piece of a dash on the line; a new dash begins where it says so.
    template <class Visit>
    void walk(const QLineF& line, Visit visit) {
        const double length = line.length();
        double walked = 0;
        while (walked < length) {
            const double step = std::min(left_, length - walked);
            if (index_ % 2 == 0)
                visit(QLineF(line.pointAt(walked / length), line.pointAt((walked + step) / length)),
                      std::exchange(isNew_, false));
            walked += step;
            left_ -= step;
            if (left_ <= 0) {
                index_ = (index_ + 1) % lengths_.size();
                left_ = lengths_[index_];
                isNew_ = true;
            }
        }
    }

  private:
    QList<double> lengths_;
    qsizetype index_ = 0;
    double left_; ///< of the present dash or gap
    bool isNew_ = true;
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
    PreparedStroke stroke{std::move(pen), std::move(polylines), {}, {}};
    const double width = stroke.pen.widthF() * devicePixelRatio;
    const bool isDashed = stroke.pen.style() == Qt::CustomDashLine;
    const bool isJoined = width > kLineWidth && canBeJoined(stroke);
    if (width <= kFastWidth || (isJoined && !isDashed))
        return stroke;
    for (const QPolygonF& polyline : stroke.polylines) {
        if (!isDashed) {
            forEachLine(polyline, [&](const QLineF& line) { stroke.lines.append(line); });
            continue;
        }
        Dashes dashes(stroke.pen);
        forEachLine(polyline, [&](const QLineF& line) {
            dashes.walk(line, [&](const QLineF& piece, bool isNew) {
                if (!isJoined)
                    stroke.lines.append(piece);
                else if (isNew)
                    stroke.dashes.push_back({piece.p1(), piece.p2()});
                else
                    stroke.dashes.back().append(piece.p2());
            });
        });
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
    for (const QPolygonF& polyline : stroke.dashes.empty() ? stroke.polylines : stroke.dashes) {
        // Each part begins with the last line of the one before, so that the joint between them has no gap. Thin
        // dashes go on from one line to the next.
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
