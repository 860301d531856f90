#include "ui/canvas/canvas_view.h"

#include "ui/canvas/canvas_accessible.h"
#include "ui/figures/caption_text.h"

#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QKeyEvent>

namespace kriva::ui {
namespace {

constexpr double kMargin = 40; ///< pixels around what is fitted or revealed: room for labels

[[nodiscard]] bool isModifierKey(int key) {
    return key == Qt::Key_Shift || key == Qt::Key_Control || key == Qt::Key_Alt || key == Qt::Key_Meta;
}

} // namespace

CanvasView::CanvasView(CanvasInput& input, QWidget* parent)
    : QGraphicsView(parent)
    , input_(input)
    , gestures_(*this, input)
    , keys_(*this, gestures_, input) {
    setScene(&scene_);
    setFrameShape(NoFrame);
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTransformationAnchor(NoAnchor);
    setViewportUpdateMode(BoundingRectViewportUpdate);
    setRenderHint(QPainter::Antialiasing);
    setFocusPolicy(Qt::StrongFocus);
    viewport()->setMouseTracking(true);
    scene_.setColorsAndFont(palette(), font());
    connect(&scene_, &CanvasScene::curvesChanged, this, [this] { gestures_.lookAgain(); });
    connect(&scene_, &CanvasScene::selectionChanged, this, [this] {
        if (scene_.selection().size() == 1)
            announcePoint(*this, scene_.selection().front());
    });
    makeAccessible();
    retranslateUi();
}

void CanvasView::choose(const GripRef& grip) {
    input_.select({grip});
    if (const auto place = scene_.curves().placeOf(grip))
        reveal(*place);
}

void CanvasView::setTool(Tool tool) {
    if (tool_ == tool)
        return;
    tool_ = tool;
    gestures_.showCursor();
    gestures_.follow(QGuiApplication::keyboardModifiers()); // a hint and a ghost without a move of the mouse
    Q_EMIT toolChanged(tool);
}

void CanvasView::retranslateUi() {
    setAccessibleName(tr("Canvas"));
    scene_.setTexts(textSource());
}

void CanvasView::setMapping(const Viewport& mapping) {
    const double before = zoomPercent();
    isFitDue_ = false;
    scene_.setMapping(mapping);
    gestures_.follow(QGuiApplication::keyboardModifiers());
    Q_EMIT mappingChanged(mapping);
    if (zoomPercent() != before)
        Q_EMIT zoomChanged(zoomPercent());
}

void CanvasView::setUnitScale(double pixelsPerUnit) {
    Viewport next = mapping();
    next.unitScale = pixelsPerUnit;
    setMapping(zoomedTo(next, next.zoom()));
}

void CanvasView::fitAll() {
    setMapping(fitted(mapping(), scene_.curves().box(), kMargin));
    isFitDue_ = true;
}

void CanvasView::fitAllAgain() {
    if (isFitDue_)
        fitAll();
}

void CanvasView::fitSelection() {
    if (scene_.selection().empty())
        fitAll();
    else
        setMapping(fitted(mapping(), boxOf(scene_.selectedPlaces()), kMargin));
}

void CanvasView::reveal(Point place) {
    setMapping(revealing(mapping(), place, kMargin));
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
        Q_EMIT pointerLeft();
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
    scene_.setDevicePixelRatio(devicePixelRatioF());
    scene_.prepare();
    QGraphicsView::paintEvent(event);
}

void CanvasView::resizeEvent(QResizeEvent* event) {
    QGraphicsView::resizeEvent(event);
    const bool isFitDue = isFitDue_;
    Viewport next = mapping();
    next.size = event->size();
    setMapping(next);
    isFitDue_ = isFitDue; // a size is nothing that somebody did on the canvas
    fitAllAgain();
}

void CanvasView::mousePressEvent(QMouseEvent* event) {
    isFitDue_ = false;
    gestures_.press(*event);
}

void CanvasView::mouseMoveEvent(QMouseEvent* event) {
    gestures_.move(*event);
    Q_EMIT pointerMoved(mapping().toDocument(event->position()));
}

void CanvasView::contextMenuEvent(QContextMenuEvent* event) {
    event->accept();
    // The right button asks by itself, when it is released without a drag.
    if (event->reason() == QContextMenuEvent::Mouse)
        return;
    const Points& places = scene_.selectedPlaces();
    const QPointF pixel = places.empty() ? scene_.sceneRect().center() : mapping().toPixels(places.front());
    input_.click(gestures_.eventAt(pixel, Qt::RightButton, {}));
}

void CanvasView::keyPressEvent(QKeyEvent* event) {
    isFitDue_ = false;
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
    if (event->reason() == Qt::ActiveWindowFocusReason)
        gestures_.follow(Qt::NoModifier); // keys are released elsewhere
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
