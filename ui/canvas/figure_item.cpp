#include "ui/canvas/figure_item.h"

#include "ui/canvas/qt_geometry.h"

#include <QPainter>

namespace kriva::ui {
namespace {

// Labels avoid marks only where these are few: with more there is no free place anyway.
constexpr std::size_t kMostObstacles = 1'000;
// QPainter strokes a long polyline of a wide pen as one shape, whose cost grows faster than its length.
constexpr qsizetype kPointsAtOnce = 64;

[[nodiscard]] bool isOfCurve(Role role) {
    return role == Role::curve || role == Role::run || role == Role::join;
}

/// Faded towards the paper, so that strokes that cross themselves stay even.
[[nodiscard]] QColor faded(const QColor& ink, const QColor& paper, double strength) {
    const auto mixed = [strength](float inkPart, float paperPart) {
        return static_cast<float>(strength) * inkPart + static_cast<float>(1 - strength) * paperPart;
    };
    return QColor::fromRgbF(mixed(ink.redF(), paper.redF()), mixed(ink.greenF(), paper.greenF()),
                            mixed(ink.blueF(), paper.blueF()));
}

void paintPolyline(QPainter& painter, const QPolygonF& polyline) {
    const bool isFast = painter.pen().widthF() <= 1 || painter.pen().style() != Qt::SolidLine;
    const qsizetype step = isFast ? polyline.size() : kPointsAtOnce;
    // Each part begins with the last line of the one before, so that the joint between them has no gap.
    for (qsizetype first = 0; first + 1 < polyline.size(); first += step) {
        const qsizetype from = std::max<qsizetype>(0, first - 1);
        const qsizetype to = std::min(polyline.size(), first + step + 1);
        painter.drawPolyline(polyline.constData() + from, static_cast<int>(to - from));
    }
}

} // namespace

void FigureItem::prepare(const Sight& sight) {
    if (seen_ != sight.rectangle()) {
        prepareGeometryChange();
        seen_ = sight.rectangle();
    }
    look_ = sight.labels;
    devicePixelRatio_ = sight.devicePixelRatio;
    pointCount_ = 0;
    curveLines_.clear();
    layers_.clear();
    layers_.reserve(figure_.layers.size());
    for (const Layer& layer : figure_.layers) {
        PreparedLayer& prepared = layers_.emplace_back();
        for (const Stroke& stroke : layer.strokes)
            prepareStroke(stroke, sight, prepared);
        for (const Marks& marks : layer.marks) {
            const RoleStyle style = styleOf(marks.role, marks.series, look_.theme);
            if (style.marker != Marker::none)
                prepared.marks.push_back(
                    stampsAt(marks.at, markPicture(style, devicePixelRatio_), sight.viewport, devicePixelRatio_));
        }
    }
    for (std::size_t i = 0; i < layers_.size(); ++i)
        layers_[i].labels = placedLabels(figure_.layers[i].labels, markBoxes(), sight.viewport, look_);
}

void FigureItem::prepareStroke(const Stroke& stroke, const Sight& sight, PreparedLayer& layer) {
    Line line{toQt(styleOf(stroke, look_.theme)), {}};
    line.pen.setColor(faded(line.pen.color(), toQt(paperColor(look_.theme)), stroke.strength));
    line.polylines = visiblePolylines(stroke.path, sight.viewport, line.pen.widthF() + 2, sight.fineness);
    for (const QPolygonF& polyline : line.polylines)
        pointCount_ += static_cast<std::size_t>(polyline.size());
    if (isOfCurve(stroke.role))
        curveLines_.insert(curveLines_.end(), line.polylines.begin(), line.polylines.end());
    layer.lines.push_back(std::move(line));
}

std::vector<QRectF> FigureItem::markBoxes() const {
    std::vector<QRectF> boxes;
    for (const PreparedLayer& layer : layers_) {
        for (const Stamps& marks : layer.marks) {
            const QSizeF size = QSizeF(marks.picture.size()) / devicePixelRatio_;
            for (const QPoint place : marks.places)
                boxes.emplace_back(QPointF(place) / devicePixelRatio_, size);
            if (boxes.size() > kMostObstacles)
                return {};
        }
    }
    return boxes;
}

void FigureItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    for (const PreparedLayer& layer : layers_) {
        for (const Line& line : layer.lines) {
            painter->setPen(line.pen);
            for (const QPolygonF& polyline : line.polylines)
                paintPolyline(*painter, polyline);
        }
        for (const Stamps& marks : layer.marks)
            kriva::ui::paint(*painter, marks, devicePixelRatio_);
        kriva::ui::paint(*painter, layer.labels, look_);
    }
}

} // namespace kriva::ui
