#pragma once

#include "ui/canvas/canvas_scene.h"
#include "ui/canvas/gestures.h"
#include "ui/canvas/key_gestures.h"

#include <QGraphicsView>

namespace kriva::ui {

/// The canvas of a tab: shows figures, turns mouse and keys into wishes, and holds what is view state: zoom, tool,
/// hover. Curves and selection are the tab's, which gives them whenever they change.
/// Actions added to the canvas are triggered by their single-key shortcuts on every keyboard layout.
class CanvasView : public QGraphicsView {
    Q_OBJECT

  public:
    explicit CanvasView(CanvasClient& client, QWidget* parent = nullptr);

    /// All curves, from the lowest to the topmost.
    void setCurves(std::vector<CanvasCurve> curves);
    /// These curves in place; the others are not touched.
    void updateCurves(std::vector<CanvasCurve> curves);
    void updateCurve(CanvasCurve curve);
    void setSelection(Selection selection);
    [[nodiscard]] const Selection& selection() const { return scene_.selection(); }

    void setTool(Tool tool);
    [[nodiscard]] Tool tool() const { return tool_; }
    /// In which colours figures are drawn; grid and paper follow the palette.
    void setTheme(Theme theme) { scene_.setTheme(theme); }
    void setGridShown(bool isShown);
    [[nodiscard]] bool isGridShown() const { return scene_.isGridShown(); }
    void setAxesShown(bool areShown) { scene_.setAxesShown(areShown); }
    [[nodiscard]] bool areAxesShown() const { return scene_.areAxesShown(); }
    /// Ends a drag that is going on as if the button had been released.
    void endGesture() { gestures_.finish(); }

    /// Pixels per document unit at 100 %. What is seen stays.
    void setUnitScale(double pixelsPerUnit);
    [[nodiscard]] double zoomPercent() const { return 100 * mapping().zoom(); }
    void zoomIn() { zoomTo(mapping().zoom() * kZoomStep); }
    void zoomOut() { zoomTo(mapping().zoom() / kZoomStep); }
    void zoomTo100() { zoomTo(1); }
    void fitAll();
    /// Fits all anew if nobody has done anything on the canvas since.
    void fitAllAgain();
    /// All, where nothing is selected.
    void fitSelection();
    [[nodiscard]] const Viewport& mapping() const { return scene_.mapping(); }
    void setMapping(const Viewport& mapping);

    // What the gestures ask for.

    [[nodiscard]] Hit hitAt(QPointF pixel) { return scene_.hitAt(pixel); }
    [[nodiscard]] Selection pointsIn(const QRectF& pixels) const { return scene_.pointsIn(pixels); }
    [[nodiscard]] std::vector<GripRef> points() const { return curves().points(); }
    [[nodiscard]] const CanvasCurves& curves() const { return scene_.curves(); }
    /// Selects this one alone and shows it: what a screen reader chooses.
    void choose(const GripRef& grip);
    void hover(QPointF pixel, Qt::KeyboardModifiers modifiers);
    /// Scrolls just so far that the grip is seen.
    void reveal(const GripRef& grip);
    void reveal(Point place);
    [[nodiscard]] std::optional<Snap> snapOf(const SnappingPlace& place) const { return scene_.snapOf(place); }
    void showSnap(std::optional<Snap> snap) { scene_.setSnap(snap); }
    /// Rings around places to look at.
    void setPointedOut(Points places) { scene_.setPointedOut(std::move(places)); }
    /// Where a point would be inserted; shown until the pointer is elsewhere.
    void setGhost(std::optional<Point> place) { scene_.setGhost(place); }
    [[nodiscard]] std::optional<Point> ghost() const { return scene_.ghost(); }
    void setRubberBand(std::optional<QRectF> band) { scene_.setRubberBand(band); }
    void requestContextMenu(QPointF pixel);
    /// Gives the focus to the next widget.
    void leave();

  Q_SIGNALS:
    void zoomChanged(double percent);
    void mappingChanged(const kriva::ui::Viewport& mapping);
    void pointerMoved(kriva::Point at);
    void pointerLeft();
    void toolChanged(kriva::ui::Tool tool);
    void gridShownChanged(bool isShown);
    /// By the right button, where it was pressed, or by the menu key.
    void contextMenuRequested(QPoint globalPosition, const kriva::ui::Hit& under);

  protected:
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override { gestures_.release(*event); }
    void mouseDoubleClickEvent(QMouseEvent* event) override { gestures_.doubleClick(*event); }
    void wheelEvent(QWheelEvent* event) override { gestures_.wheel(*event); }
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    bool focusNextPrevChild(bool isNext) override;

  private:
    void retranslateUi();
    void zoomTo(double zoom) { setMapping(zoomedTo(mapping(), zoom)); }

    CanvasClient& client_;
    CanvasScene scene_;
    Gestures gestures_;
    KeyGestures keys_;
    Tool tool_ = Tool::edit;
    bool isFitDue_ = false; ///< until a person does something on it, a new size fits all again
};

} // namespace kriva::ui
