#pragma once

#include "ui/canvas/canvas_scene.h"
#include "ui/canvas/gestures.h"
#include "ui/canvas/key_gestures.h"

#include <QGraphicsView>

namespace kriva::ui {

/// The canvas of a tab: shows its scene, hands mouse and keys to its gestures, and holds the tool and the zoom. Curves
/// and selection are the input's, which gives them to the scene whenever they change.
/// Actions added to the canvas are triggered by their single-key shortcuts on every keyboard layout.
class CanvasView : public QGraphicsView {
    Q_OBJECT

  public:
    /// `input` outlives the canvas.
    explicit CanvasView(CanvasInput& input, QWidget* parent = nullptr);

    /// What is shown on it.
    [[nodiscard]] CanvasScene& scene() { return scene_; }

    void setTool(Tool tool);
    [[nodiscard]] Tool tool() const { return tool_; }

    [[nodiscard]] const Viewport& mapping() const { return scene_.mapping(); }
    void setMapping(const Viewport& mapping);
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
    /// Scrolls just so far that the place is seen.
    void reveal(Point place);

    /// Selects this one alone and reveals it.
    void choose(const GripRef& grip);
    /// Gives the focus to the next widget.
    void leave() { QGraphicsView::focusNextPrevChild(true); }

  Q_SIGNALS:
    void zoomChanged(double percent);
    void mappingChanged(const kriva::ui::Viewport& mapping);
    void pointerMoved(kriva::Point at);
    void pointerLeft();
    void toolChanged(kriva::ui::Tool tool);

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

    CanvasInput& input_;
    CanvasScene scene_;
    Gestures gestures_;
    KeyGestures keys_;
    Tool tool_ = Tool::edit;
    bool isFitDue_ = false; ///< until a person does something on it, a new size fits all again
};

} // namespace kriva::ui
