#pragma once

#include "ui/canvas/drawing/grid.h"
#include "ui/canvas/drawing/highlights.h"
#include "ui/canvas/figure_item.h"
#include "ui/canvas/hit_test.h"

#include <QGraphicsScene>

namespace kriva::ui {

/// What a canvas shows of one curve of the sheet.
struct CanvasCurve {
    Serial serial = 0;
    Figure figure;
    std::vector<Grip> grips; ///< of what is shown: what is hidden is never hit
    bool isActive = false;
    bool isOnTop = false; ///< drawn over the active curve
};

/// The figures, grips and highlights of a canvas in its pixels. It holds what it was given and knows no gesture;
/// everything is worked out when it is next painted or asked what lies under a pixel.
class CanvasScene : public QGraphicsScene {
    Q_OBJECT

  public:
    explicit CanvasScene(QObject* parent = nullptr);

    void setCurves(std::vector<CanvasCurve> curves);
    void updateCurve(CanvasCurve curve);
    void setSelection(Selection selection);
    [[nodiscard]] const Selection& selection() const { return selection_; }
    void setHovered(std::optional<GripRef> grip);
    /// Where a point would be inserted.
    void setGhost(std::optional<Point> place);
    [[nodiscard]] std::optional<Point> ghost() const { return ghost_; }
    void setRubberBand(std::optional<QRectF> band);

    void setMapping(const Viewport& mapping);
    [[nodiscard]] const Viewport& mapping() const { return sight_.viewport; }
    void setDevicePixelRatio(double ratio);
    void setTheme(Theme theme);
    void setTexts(TextSource texts);
    void setColorsAndFont(const QPalette& palette, const QFont& font);
    void setGridShown(bool isShown);
    [[nodiscard]] bool isGridShown() const { return grid_.hasGrid; }
    void setAxesShown(bool areShown);
    [[nodiscard]] bool areAxesShown() const { return grid_.hasAxes; }

    /// Brings the items up to date with everything given; paint() needs it.
    void prepare();

    [[nodiscard]] Hit hitAt(QPointF pixel);
    [[nodiscard]] Selection pointsIn(const QRectF& pixels) const;
    /// All points that can be taken hold of, by curve and index.
    [[nodiscard]] std::vector<GripRef> points() const;
    [[nodiscard]] std::optional<Point> placeOf(const GripRef& grip) const;
    /// Of all figures and grips.
    [[nodiscard]] Box box() const;
    [[nodiscard]] Points selectedPlaces() const;

  protected:
    void drawBackground(QPainter* painter, const QRectF& rectangle) override;
    void drawForeground(QPainter* painter, const QRectF& rectangle) override;

  private:
    struct Entry {
        Serial serial = 0;
        bool isActive = false;
        bool isPrepared = false;
        std::vector<Grip> grips;
        FigureItem* item = nullptr; ///< owned by the scene
    };

    void fill(Entry& entry, CanvasCurve curve);
    void invalidate();
    void prepareItems();
    void prepareHighlights();
    [[nodiscard]] std::vector<HitTarget> targets() const;

    std::vector<Entry> entries_;
    Selection selection_;
    std::optional<GripRef> hovered_;
    std::optional<Point> ghost_;
    std::optional<QRectF> band_;
    Sight sight_;
    GridLook grid_;
    HighlightColors colors_;
    std::vector<Stamps> highlights_;
    bool areHighlightsPrepared_ = false;
};

} // namespace kriva::ui
