#include "ui/canvas/figure_item.h"

#include "ui/canvas/qt_geometry.h"

#include <QPainter>

#include <algorithm>

namespace kriva::ui {
namespace {

// QPainter strokes a long polyline of a wide pen as one shape, whose cost grows faster than its length.
constexpr qsizetype kPointsAtOnce = 64;
// Pairs of a label and something it might cover that are looked at in a frame.
constexpr std::size_t kMostPairs = 200'000;

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

// Core places labels on a page in millimetres. What is seen is such a page, its document units being pixels, y up.

[[nodiscard]] Page pageOfView(QSizeF size) {
    return {size.width() / kPixelsPerMillimetre,
            size.height() / kPixelsPerMillimetre,
            1 / kPixelsPerMillimetre,
            0,
            {0, -size.height(), size.width(), 0}};
}
[[nodiscard]] Point onPageOfView(QPointF pixel) {
    return {pixel.x(), -pixel.y()};
}

[[nodiscard]] Layer axesOfView(const Viewport& viewport) {
    const Point origin = onPageOfView(viewport.toPixels({}));
    const Points across{{0, origin.y}, {viewport.size.width(), origin.y}};
    const Points upwards{{origin.x, -viewport.size.height()}, {origin.x, 0}};
    return {"axes", {{polyline(across), Role::construction}, {polyline(upwards), Role::construction}}};
}

} // namespace

void FigureItem::prepare(const Sight& sight) {
    if (seen_ != sight.rectangle()) {
        prepareGeometryChange();
        seen_ = sight.rectangle();
    }
    devicePixelRatio_ = sight.devicePixelRatio;
    labelColor_ = toQt(styleOf(Role::label, 0, sight.theme).color);
    pointCount_ = 0;
    curveLines_.clear();
    layers_.clear();
    layers_.reserve(figure_.layers.size());
    for (const Layer& layer : figure_.layers) {
        PreparedLayer& prepared = layers_.emplace_back();
        for (const Stroke& stroke : layer.strokes)
            prepareStroke(stroke, sight, prepared);
        for (const Marks& marks : layer.marks) {
            const RoleStyle style = styleOf(marks, sight.theme);
            if (style.marker != Marker::none)
                prepared.marks.push_back(
                    stampsAt(marks.at, markPicture(style, devicePixelRatio_), sight.viewport, devicePixelRatio_));
        }
    }
    prepareLabels(sight);
}

void FigureItem::prepareStroke(const Stroke& stroke, const Sight& sight, PreparedLayer& layer) {
    Line line{penOf(styleOf(stroke, sight.theme), kPixelsPerPoint), stroke.role, {}};
    line.pen.setColor(faded(line.pen.color(), toQt(paperColor(sight.theme)), stroke.strength));
    line.polylines = visiblePolylines(stroke.path, sight.viewport, line.pen.widthF() + 2, sight.fineness);
    for (const QPolygonF& polyline : line.polylines)
        pointCount_ += static_cast<std::size_t>(polyline.size());
    if (isOfCurve(stroke.role))
        curveLines_.insert(curveLines_.end(), line.polylines.begin(), line.polylines.end());
    layer.lines.push_back(std::move(line));
}

void FigureItem::prepareLabels(const Sight& sight) {
    Figure seen = seenFigure(seenLabels(sight.viewport));
    if (sight.hasAxes) // in the way of labels, though drawn elsewhere
        seen.layers.push_back(axesOfView(sight.viewport));
    const auto placed = placedLabels(seen, pageOfView(sight.viewport.size), sight.texts);
    for (std::size_t i = 0; i < layers_.size(); ++i)
        layers_[i].labels = placed[i];
}

std::vector<std::vector<Label>> FigureItem::seenLabels(const Viewport& viewport) const {
    std::vector<std::vector<Label>> labels(figure_.layers.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (Label label : figure_.layers[i].labels) {
            const QPointF pixel = viewport.toPixels(label.at);
            if (!seen_.contains(pixel))
                continue;
            if (++count > kMostLabels)
                return std::vector<std::vector<Label>>(labels.size());
            label.at = onPageOfView(pixel);
            labels[i].push_back(std::move(label));
        }
    }
    return labels;
}

Figure FigureItem::seenFigure(std::vector<std::vector<Label>> labels) const {
    std::size_t labelCount = 0;
    std::size_t obstacles = pointCount_;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        labelCount += labels[i].size();
        for (const Stamps& marks : layers_[i].marks)
            obstacles += marks.places.size();
    }
    const bool areObstaclesSeen = labelCount * obstacles <= kMostPairs;
    Figure seen;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        Layer& layer = seen.layers.emplace_back();
        layer.labels = std::move(labels[i]);
        if (labelCount == 0 || !areObstaclesSeen)
            continue;
        for (const Line& line : layers_[i].lines) {
            for (const QPolygonF& polyline : line.polylines) {
                Points points;
                std::ranges::transform(polyline, std::back_inserter(points), onPageOfView);
                layer.strokes.push_back({.path = kriva::polyline(points), .role = line.role});
            }
        }
        for (const Stamps& marks : layers_[i].marks) {
            Marks& at = layer.marks.emplace_back();
            const QPointF middle = QRectF(marks.picture.rect()).center();
            for (const QPoint place : marks.places)
                at.at.push_back(onPageOfView((place + middle) / devicePixelRatio_));
        }
    }
    return seen;
}

void FigureItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    const LabelFonts fonts = labelFonts(kPixelsPerPoint);
    for (const PreparedLayer& layer : layers_) {
        for (const Line& line : layer.lines) {
            painter->setPen(line.pen);
            for (const QPolygonF& polyline : line.polylines)
                paintPolyline(*painter, polyline);
        }
        for (const Stamps& marks : layer.marks)
            kriva::ui::paint(*painter, marks, devicePixelRatio_);
        painter->setPen(labelColor_);
        for (const PlacedLabel& label : layer.labels)
            paintLabel(*painter, label, kPixelsPerMillimetre * toQt(label.baseline), fonts);
    }
}

} // namespace kriva::ui
