#include "ui/canvas/drawing/figure_item.h"

#include "ui/canvas/base/qt_geometry.h"
#include "ui/canvas/drawing/difference.h"

#include <QPainter>
#include <QStyleOptionGraphicsItem>

#include <algorithm>

namespace kriva::ui {
namespace {

// Pairs of a label and something it might cover that are looked at in a frame.
constexpr double kMostPairs = 200'000;

/// Faded towards the paper, so that strokes that cross themselves stay even.
[[nodiscard]] QColor faded(const QColor& ink, const QColor& paper, double strength) {
    const auto mixed = [strength](float inkPart, float paperPart) {
        return static_cast<float>(strength) * inkPart + static_cast<float>(1 - strength) * paperPart;
    };
    return QColor::fromRgbF(mixed(ink.redF(), paper.redF()), mixed(ink.greenF(), paper.greenF()),
                            mixed(ink.blueF(), paper.blueF()));
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

void FigureItem::prepare(const Sight& sight, MarkPictures& pictures, FrameLoad& frame) {
    if (seen_ != sight.rectangle()) {
        prepareGeometryChange();
        seen_ = sight.rectangle();
    }
    devicePixelRatio_ = sight.devicePixelRatio;
    theme_ = sight.theme;
    curveLines_.clear();
    layers_.clear();
    layers_.reserve(figure_.layers.size());
    const FrameLoad before = frame;
    for (const Layer& layer : figure_.layers)
        prepareLayer(layer, sight, pictures, frame);
    load_ = frame - before;
    if (!frame.isTooMuch())
        prepareLabels(sight);
}

void FigureItem::prepareLayer(const Layer& layer, const Sight& sight, MarkPictures& pictures, FrameLoad& frame) {
    PreparedLayer& seen = layers_.emplace_back();
    if (frame.isTooMuch())
        return;
    for (const Stroke& stroke : layer.strokes)
        seen.strokes.push_back(prepared(stroke, sight, frame));
    StampView view{sight.viewport, devicePixelRatio_, sight.fineness.markSpacing};
    for (const Marks& marks : layer.marks) {
        const RoleStyle style = styleOf(marks, sight.theme);
        if (style.marker == Marker::none)
            continue;
        view.most = FrameLoad::kMarks - frame.marks;
        seen.marks.push_back(stampsAt(marks.at, pictures.picture(style, devicePixelRatio_), view));
        frame.marks += static_cast<double>(seen.marks.back().places.size());
    }
}

PreparedStroke FigureItem::prepared(const Stroke& stroke, const Sight& sight, FrameLoad& frame) {
    QPen pen = penOf(styleOf(stroke, sight.theme), kPixelsPerPoint);
    pen.setColor(faded(pen.color(), toQt(paperColor(sight.theme)), stroke.strength));
    PreparedStroke result =
        preparedStroke(visiblePolylines(stroke.path, sight.viewport, pen.widthF(), sight.fineness, frame), pen,
                       sight.devicePixelRatio);
    if (isOfCurve(stroke.role))
        curveLines_.insert(curveLines_.end(), result.polylines.begin(), result.polylines.end());
    return result;
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
    for (const std::vector<Label>& ofLayer : labels)
        labelCount += ofLayer.size();
    const bool areObstaclesSeen =
        labelCount > 0 && static_cast<double>(labelCount) * (load_.points + load_.marks) <= kMostPairs;
    Figure seen;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        Layer& layer = seen.layers.emplace_back();
        layer.labels = std::move(labels[i]);
        if (!areObstaclesSeen)
            continue;
        for (std::size_t k = 0; k < layers_[i].strokes.size(); ++k) {
            for (const QPolygonF& seenLine : layers_[i].strokes[k].polylines) {
                Points points;
                std::ranges::transform(seenLine, std::back_inserter(points), onPageOfView);
                layer.strokes.push_back({.path = polyline(points), .role = figure_.layers[i].strokes[k].role});
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

Box FigureItem::difference(const PreparedLayer& before, const PreparedLayer& after) const {
    return united(differenceOfEach(before.strokes, after.strokes),
                  united(differenceOfEach(before.marks, after.marks, devicePixelRatio_),
                         kriva::ui::difference(before.labels, after.labels)));
}

Box FigureItem::settle() {
    Box changed;
    const PreparedLayer none;
    for (std::size_t i = 0; i < std::max(settled_.size(), layers_.size()); ++i)
        changed = united(changed,
                         difference(i < settled_.size() ? settled_[i] : none, i < layers_.size() ? layers_[i] : none));
    settled_ = layers_; // polylines are shared
    return changed;
}

void FigureItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
    draw(*painter, option->exposedRect);
}

void FigureItem::draw(QPainter& painter, const QRectF& seen) const {
    const LabelFonts fonts = labelFonts(kPixelsPerPoint);
    for (const PreparedLayer& layer : layers_) {
        for (const PreparedStroke& stroke : layer.strokes)
            kriva::ui::paint(painter, stroke, seen);
        for (const Stamps& marks : layer.marks)
            kriva::ui::paint(painter, marks, devicePixelRatio_);
        for (const PlacedLabel& label : layer.labels) {
            painter.setPen(toQt(labelColor(label.role, theme_)));
            paintLabel(painter, label, kPixelsPerMillimetre * toQt(label.baseline), fonts);
        }
    }
}

} // namespace kriva::ui
