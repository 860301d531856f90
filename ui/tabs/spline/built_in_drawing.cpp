#include "ui/tabs/spline/built_in_drawing.h"

#include "core/bezier/bounds.h"
#include "core/bezier/cubic_pieces.h"
#include "core/sheets/spline/layers/spline_layers.h"
#include "ui/canvas/base/qt_geometry.h"

#include <QPainterPath>
#include <QTransform>

#include <algorithm>
#include <limits>

namespace kriva::ui {
namespace {

constexpr double kPixels = 1000;        // the longer side of the chain as it is drawn
constexpr double kCubicTolerance = 0.1; // pixels: far below what the flattening leaves

/// Of a segment of the usual number of points.
constexpr std::uint64_t kStepsOfSegment = 20;

[[nodiscard]] QPainterPath pathOf(const Points& segment, double pixelsPerUnit) {
    QPainterPath path(toQt(segment.front()));
    if (segment.size() == 3) {
        path.quadTo(toQt(segment[1]), toQt(segment[2]));
        return path;
    }
    for (const Cubic& piece : cubicPieces(segment, Tolerance{kCubicTolerance / pixelsPerUnit}))
        path.cubicTo(toQt(piece[1]), toQt(piece[2]), toQt(piece[3]));
    return path;
}

/// The corners of the lines by which Qt draws the path.
[[nodiscard]] Points drawnCorners(const QPainterPath& path, double pixelsPerUnit) {
    Points corners;
    for (const QPolygonF& polygon : path.toSubpathPolygons(QTransform::fromScale(pixelsPerUnit, pixelsPerUnit)))
        for (const QPointF& corner : polygon)
            corners.push_back({corner.x() / pixelsPerUnit, corner.y() / pixelsPerUnit});
    return corners;
}

[[nodiscard]] double distanceToLine(Point p, Point a, Point b) {
    const Vector along = b - a;
    const double square = dot(along, along);
    const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
    return distance(p, a + t * along);
}

/// The largest distance of a corner of `from` to the polyline `to`.
[[nodiscard]] double farthest(const Points& from, const Points& to) {
    double largest = 0;
    for (const Point corner : from) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i + 1 < to.size(); ++i)
            nearest = std::min(nearest, distanceToLine(corner, to[i], to[i + 1]));
        largest = std::max(largest, nearest);
    }
    return largest;
}

} // namespace

std::optional<double> deviationFromBuiltIn(const SplineCurve& curve, int points, WorkBudget& budget) {
    if (isIncomplete(curve))
        return 0.0;
    const std::vector<Points> segments = segmentsOf(curve);
    Box box;
    for (const Points& segment : segments)
        box = united(box, tightBounds(segment));
    const double extent = std::max(box.width(), box.height());
    if (extent == 0)
        return 0.0;
    const double pixelsPerUnit = kPixels / extent;
    double deviation = 0;
    for (const Points& segment : segments) {
        if (!budget.spend(kStepsOfSegment))
            return {};
        const Points drawn = drawnCorners(pathOf(segment, pixelsPerUnit), pixelsPerUnit);
        const Points polyline = deCasteljauPolyline(std::span(&segment, 1), points);
        deviation = std::max({deviation, farthest(drawn, polyline), farthest(polyline, drawn)});
    }
    return deviation;
}

} // namespace kriva::ui
