#include "ui/canvas/canvas_view.h"

#include "ui/figures/caption_text.h"

#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace kriva::ui {
namespace {

constexpr double kMargin = 40;         ///< pixels around what is fitted or revealed: room for labels
constexpr double kZoomStep = 1.25;     ///< of Zoom in and of a notch of the wheel
constexpr double kNotchAngle = 120;    ///< of a wheel, in eighths of a degree
constexpr double kPixelsPerNotch = 60; ///< three lines, as elsewhere

[[nodiscard]] bool isModifierKey(int key) {
    return key == Qt::Key_Shift || key == Qt::Key_Control || key == Qt::Key_Alt || key == Qt::Key_Meta;
}

/// How far to move a pixel to have it between `low` and `high`.
[[nodiscard]] double wayInto(double pixel, double low, double high) {
    return low <= high ? std::clamp(pixel, low, high) - pixel : 0;
}

} // namespace

CanvasView::CanvasView(CanvasClient& client, QWidget* parent)
    : QGraphicsView(parent)
    , client_(client)
    , gestures_(*this, client)
    , keys_(*this, gestures_, client) {
    setScene(&scene_);
    setFrameShape(NoFrame);
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTransformationAnchor(NoAnchor);
    setViewportUpdateMode(FullViewportUpdate);
    setRenderHint(QPainter::Antialiasing);
    setFocusPolicy(Qt::StrongFocus);
    viewport()->setMouseTracking(true);
    scene_.setColorsAndFont(palette(), font());
    retranslateUi();
}

void CanvasView::setTool(Tool tool) {
    if (tool_ == tool)
        return;
    tool_ = tool;
    gestures_.showCursor();
    Q_EMIT toolChanged(tool);
}

void CanvasView::retranslateUi() {
    scene_.setTexts(textSource());
}

void CanvasView::setGridShown(bool isShown) {
    if (isGridShown() == isShown)
        return;
    scene_.setGridShown(isShown);
    Q_EMIT gridShownChanged(isShown);
}

void CanvasView::setMapping(const Viewport& mapping) {
    const double before = zoomPercent();
    scene_.setMapping(mapping);
    gestures_.follow(QGuiApplication::keyboardModifiers());
    if (zoomPercent() != before)
        Q_EMIT zoomChanged(zoomPercent());
}

void CanvasView::setUnitScale(double pixelsPerUnit) {
    Viewport next = mapping();
    next.unitScale = pixelsPerUnit;
    setMapping(zoomedTo(next, next.zoom()));
}

void CanvasView::zoomAround(QPointF pixel, double factor) {
    isFitDue_ = false;
    setMapping(zoomedAt(mapping(), pixel, factor));
}

void CanvasView::zoomIn() {
    zoomAround(scene_.sceneRect().center(), kZoomStep);
}

void CanvasView::zoomOut() {
    zoomAround(scene_.sceneRect().center(), 1 / kZoomStep);
}

void CanvasView::zoomTo100() {
    isFitDue_ = false;
    setMapping(zoomedTo(mapping(), 1));
}

void CanvasView::fitAll() {
    isFitDue_ = true;
    fit(scene_.box());
}

void CanvasView::fitSelection() {
    isFitDue_ = false;
    fit(selection().empty() ? scene_.box() : boxOf(scene_.selectedPlaces()));
}

void CanvasView::fit(const kriva::Box& box) {
    setMapping(fitted(mapping(), box, kMargin));
}

void CanvasView::reveal(const GripRef& grip) {
    const auto place = scene_.placeOf(grip);
    if (!place)
        return;
    const QPointF pixel = mapping().toPixels(*place);
    const QSizeF size = mapping().size;
    const QPointF way(wayInto(pixel.x(), kMargin, size.width() - kMargin),
                      wayInto(pixel.y(), kMargin, size.height() - kMargin));
    if (!way.isNull())
        setMapping(panned(mapping(), way));
}

void CanvasView::hover(QPointF pixel, Qt::KeyboardModifiers modifiers) {
    const Hit under = hitAt(pixel);
    scene_.setHovered(under.grip);
    client_.hover(under, mapping().toDocument(pixel), modifiers);
}

void CanvasView::requestContextMenu(QPointF pixel) {
    Q_EMIT contextMenuRequested(viewport()->mapToGlobal(pixel.toPoint()), hitAt(pixel));
}

void CanvasView::leave() {
    QGraphicsView::focusNextPrevChild(true);
}

bool CanvasView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && keys_.wants(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QGraphicsView::event(event);
}

bool CanvasView::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::Leave) {
        gestures_.leave();
        scene_.setHovered(std::nullopt);
    } else if (event->type() == QEvent::UngrabMouse) {
        gestures_.finish();
    }
    return QGraphicsView::viewportEvent(event);
}

void CanvasView::changeEvent(QEvent* event) {
    QGraphicsView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        scene_.setColorsAndFont(palette(), font());
    else if (event->type() == QEvent::LanguageChange)
        retranslateUi();
}

void CanvasView::paintEvent(QPaintEvent* event) {
    isFitDue_ = false;
    scene_.setDevicePixelRatio(devicePixelRatioF());
    scene_.prepare();
    QGraphicsView::paintEvent(event);
}

void CanvasView::resizeEvent(QResizeEvent* event) {
    QGraphicsView::resizeEvent(event);
    Viewport next = mapping();
    next.size = event->size();
    setMapping(next);
    if (isFitDue_)
        fitAll();
}

void CanvasView::mousePressEvent(QMouseEvent* event) {
    gestures_.press(*event);
}

void CanvasView::mouseMoveEvent(QMouseEvent* event) {
    gestures_.move(*event);
    Q_EMIT pointerMoved(mapping().toDocument(event->position()));
}

void CanvasView::mouseReleaseEvent(QMouseEvent* event) {
    gestures_.release(*event);
}

void CanvasView::mouseDoubleClickEvent(QMouseEvent* event) {
    gestures_.doubleClick(*event);
}

void CanvasView::wheelEvent(QWheelEvent* event) {
    event->accept();
    const QPointF notches = QPointF(event->angleDelta()) / kNotchAngle;
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        zoomAround(event->position(), std::pow(kZoomStep, notches.y()));
        return;
    }
    QPointF way = event->pixelDelta().isNull() ? kPixelsPerNotch * notches : QPointF(event->pixelDelta());
    if (event->modifiers().testFlag(Qt::ShiftModifier))
        way = way.transposed();
    isFitDue_ = false;
    setMapping(panned(mapping(), way));
}

void CanvasView::contextMenuEvent(QContextMenuEvent* event) {
    event->accept();
    // The right button asks by itself, when it is released without a drag.
    if (event->reason() == QContextMenuEvent::Mouse)
        return;
    const Points places = scene_.selectedPlaces();
    requestContextMenu(places.empty() ? scene_.sceneRect().center() : mapping().toPixels(places.front()));
}

void CanvasView::keyPressEvent(QKeyEvent* event) {
    if (isModifierKey(event->key()))
        gestures_.follow(event->modifiers());
    event->setAccepted(keys_.press(*event));
}

void CanvasView::keyReleaseEvent(QKeyEvent* event) {
    if (isModifierKey(event->key()))
        gestures_.follow(event->modifiers());
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat())
        gestures_.setSpaceHeld(false);
    event->ignore();
}

void CanvasView::focusOutEvent(QFocusEvent* event) {
    gestures_.finish();
    gestures_.setSpaceHeld(false);
    QGraphicsView::focusOutEvent(event);
}

void CanvasView::hideEvent(QHideEvent* event) {
    gestures_.finish();
    QGraphicsView::hideEvent(event);
}

bool CanvasView::focusNextPrevChild(bool isNext) {
    return keys_.walk(isNext) || QGraphicsView::focusNextPrevChild(isNext);
}

} // namespace kriva::ui
