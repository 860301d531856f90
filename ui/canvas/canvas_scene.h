#pragma once

#include "ui/canvas/base/grid.h"
#include "ui/canvas/base/snapping.h"
#include "ui/canvas/canvas_curves.h"
#include "ui/canvas/drawing/highlights.h"

#include <QGraphicsScene>

namespace kriva::ui {

/// The figures, grips and highlights of a canvas in its pixels. It holds what it was given and knows no gesture. What
/// is seen is worked out when it is next painted or asked what lies under a pixel, but what a hand moves at once: no
/// more is painted than what that changes.
class CanvasScene : public QGraphicsScene {
    Q_OBJECT

  public:
    explicit CanvasScene(QObject* parent = nullptr);

    /// All curves, from the lowest to the topmost.
    void setCurves(std::vector<CanvasCurve> curves);
    /// These curves in place; the others are not touched.
    void updateCurves(std::vector<CanvasCurve> curves);
    void updateCurve(CanvasCurve curve);
    void setSelection(Selection selection);
    [[nodiscard]] const Selection& selection() const { return selection_; }
    void setHovered(std::optional<GripRef> grip);
    /// Places to look at, such as crossings: each has a wide ring.
    void setPointedOut(Points places);
    /// Where a point would be inserted.
    void setGhost(std::optional<Point> place);
    [[nodiscard]] std::optional<Point> ghost() const { return ghost_; }
    void setRubberBand(std::optional<QRectF> band);
    /// What the dragged point snapped to, shown by a mark.
    void setSnap(std::optional<Snap> snap);

    /// The view's, which fits and zooms.
    void setMapping(const Viewport& mapping);
    [[nodiscard]] const Viewport& mapping() const { return sight_.viewport; }
    void setDevicePixelRatio(double ratio);
    /// In which colours figures are drawn; grid and paper follow the palette.
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
    /// To what a place snaps among the curves that are shown and, where it is, the grid.
    [[nodiscard]] std::optional<Snap> snapOf(const SnappingPlace& place) const;
    [[nodiscard]] const CanvasCurves& curves() const { return curves_; }
    [[nodiscard]] const Points& selectedPlaces();

  Q_SIGNALS:
    /// They look different now.
    void curvesChanged();
    void gridShownChanged(bool isShown);

  protected:
    void drawBackground(QPainter* painter, const QRectF& rectangle) override;
    void drawForeground(QPainter* painter, const QRectF& rectangle) override;

  private:
    void invalidate();
    void prepareHighlights();
    /// Brings the highlights up to date and paints what is different.
    void followHighlights();
    void updateIn(const Box& changed);
    /// Around a mark that paintSnap or paintGhost puts there.
    void updateAround(std::optional<Point> place);

    CanvasCurves curves_{*this};
    Selection selection_;
    std::optional<Points> selectedPlaces_; ///< as long as they are known
    std::optional<GripRef> hovered_;
    Points pointedOut_;
    std::optional<Point> ghost_;
    std::optional<QRectF> band_;
    std::optional<Snap> snap_;
    Sight sight_;
    GridLook grid_;
    HighlightColors colors_;
    std::vector<Stamps> highlights_;
    bool areHighlightsPrepared_ = false;
};

} // namespace kriva::ui
