#pragma once

#include "ui/canvas/drawing/prepared_stroke.h"
#include "ui/canvas/drawing/stamps.h"
#include "ui/canvas/drawing/visible_path.h"
#include "ui/figures/figure_ink.h"

#include <QGraphicsItem>

namespace kriva::ui {

/// How a canvas shows its figures at the moment.
struct Sight {
    Viewport viewport;
    Theme theme = Theme::light;
    TextSource texts;
    Fineness fineness;
    double devicePixelRatio = 1;
    bool hasAxes = true; ///< behind the figures

    [[nodiscard]] QRectF rectangle() const { return {{}, viewport.size}; }
};

/// Nobody reads more labels than this at once: beyond it none is drawn.
inline constexpr std::size_t kMostLabels = 200;

/// The figure of one curve. What is seen of it is worked out in prepare(); painting only draws.
class FigureItem : public QGraphicsItem {
  public:
    FigureItem() { setFlag(ItemUsesExtendedStyleOption); } // which part of it is to be painted
    void setFigure(Figure figure) { figure_ = std::move(figure); }
    [[nodiscard]] const Figure& figure() const { return figure_; }

    /// Adds to the load of the frame, and stops early where that is too much.
    void prepare(const Sight& sight, MarkPictures& pictures, FrameLoad& frame);
    /// What is prepared now is what is painted next: where, in pixels, that differs from what it was at the last call.
    [[nodiscard]] Box settle();
    /// Its part of the frame.
    [[nodiscard]] const FrameLoad& load() const { return load_; }
    /// The polylines of the curve itself, by which it is taken hold of.
    [[nodiscard]] const std::vector<QPolygonF>& curveLines() const { return curveLines_; }

    /// At least what is seen of it in the rectangle.
    void draw(QPainter& painter, const QRectF& seen) const;

    [[nodiscard]] QRectF boundingRect() const override { return seen_; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

  private:
    struct PreparedLayer {
        std::vector<PreparedStroke> strokes;
        std::vector<Stamps> marks;
        std::vector<PlacedLabel> labels;
    };
    [[nodiscard]] Box difference(const PreparedLayer& before, const PreparedLayer& after) const;

    void prepareLayer(const Layer& layer, const Sight& sight, MarkPictures& pictures, FrameLoad& frame);
    [[nodiscard]] PreparedStroke prepared(const Stroke& stroke, const Sight& sight, FrameLoad& frame);
    void prepareLabels(const Sight& sight);
    [[nodiscard]] std::vector<std::vector<Label>> seenLabels(const Viewport& viewport) const;
    [[nodiscard]] Figure seenFigure(std::vector<std::vector<Label>> labels) const;

    Figure figure_;
    std::vector<PreparedLayer> layers_;
    std::vector<PreparedLayer> settled_;
    std::vector<QPolygonF> curveLines_;
    FrameLoad load_;
    double devicePixelRatio_ = 1;
    Theme theme_ = Theme::light;
    QRectF seen_;
};

} // namespace kriva::ui
