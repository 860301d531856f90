#include "ui/canvas/gestures.h"

#include "ui/canvas/base/qt_geometry.h"
#include "ui/canvas/canvas_view.h"
#include "ui/canvas/drags.h"

#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace kriva::ui {
namespace {

constexpr double kClickReach = 4;      ///< pixels: less movement is a click
constexpr double kNotchAngle = 120;    ///< of a wheel, in eighths of a degree
constexpr double kPixelsPerNotch = 60; ///< three lines, as elsewhere

} // namespace

Gestures::Gestures(CanvasView& view, CanvasClient& client)
    : view_(view)
    , client_(client) {}

void Gestures::press(const QMouseEvent& event) {
    pixel_ = event.position();
    const bool isOurs = event.button() & (Qt::LeftButton | Qt::MiddleButton | Qt::RightButton);
    if (isRunning() && event.button() == Qt::RightButton)
        cancel();
    else if (!isRunning() && isOurs)
        begin(event);
}

void Gestures::begin(const QMouseEvent& event) {
    press_ = pressOf(event);
    const bool isPanning = press_.button == Qt::MiddleButton || (press_.button == Qt::LeftButton && isSpaceHeld_);
    setState(isPanning ? State::panning : State::pressed);
}

Press Gestures::pressOf(const QMouseEvent& event) const {
    const QPointF pixel = event.position();
    return {pixel, view_.mapping().toDocument(pixel), event.button(), event.modifiers(), view_.hitAt(pixel)};
}

void Gestures::move(const QMouseEvent& event) {
    const QPointF before = pixel_;
    pixel_ = event.position();
    isPointerInside_ = true;
    if (isRunning() && !event.buttons().testFlag(press_.button))
        finish(); // the release went elsewhere
    if (state_ == State::pressed && distance(toCore(pixel_), toCore(press_.pixel)) >= kClickReach)
        startDrag();
    if (state_ == State::panning)
        view_.setMapping(panned(view_.mapping(), pixel_ - before));
    else
        follow(event.modifiers());
}

void Gestures::follow(Qt::KeyboardModifiers modifiers) {
    modifiers_ = modifiers;
    if (state_ == State::dragging)
        client_.drag(wayOf(press_, view_.mapping().toDocument(pixel_), modifiers), {modifiers, isSpaceHeld_});
    else if (state_ == State::banding)
        view_.setRubberBand(band());
    else
        lookAgain();
}

void Gestures::lookAgain() {
    if (state_ == State::idle && isPointerInside_)
        view_.hover(pixel_, modifiers_);
}

void Gestures::wheel(QWheelEvent& event) {
    event.accept();
    const QPointF notches = QPointF(event.angleDelta()) / kNotchAngle;
    if (event.modifiers().testFlag(Qt::ControlModifier)) {
        view_.setMapping(zoomedAt(view_.mapping(), event.position(), std::pow(kZoomStep, notches.y())));
        return;
    }
    const QPointF way = event.pixelDelta().isNull() ? kPixelsPerNotch * notches : QPointF(event.pixelDelta());
    const bool isSideways = event.modifiers().testFlag(Qt::ShiftModifier);
    view_.setMapping(panned(view_.mapping(), isSideways ? way.transposed() : way));
}

void Gestures::leave() {
    isPointerInside_ = false;
    view_.setGhost(std::nullopt);
}

void Gestures::release(const QMouseEvent& event) {
    pixel_ = event.position();
    if (!isRunning() || event.button() != press_.button)
        return;
    if (state_ == State::pressed) {
        setState(State::idle);
        click(press_, view_, client_);
    } else {
        finish();
    }
    follow(event.modifiers());
}

void Gestures::doubleClick(const QMouseEvent& event) {
    const Press second = pressOf(event);
    const bool isPlain = second.button == Qt::LeftButton && second.modifiers == Qt::NoModifier;
    // Elsewhere the second press is one more click.
    if (isRunning() || !isPlain || isSpaceHeld_ || view_.tool() == Tool::add || second.under.grip)
        press(event);
    else
        kriva::ui::doubleClick(second, client_);
}

void Gestures::setSpaceHeld(bool isHeld) {
    if (std::exchange(isSpaceHeld_, isHeld) == isHeld)
        return;
    showCursor();
    if (state_ == State::dragging)
        follow(modifiers_);
}

std::optional<CurvePlace> Gestures::curveUnderPointer() const {
    const std::optional<Serial> curve = isPointerInside_ ? view_.hitAt(pixel_).curve : std::nullopt;
    if (!curve)
        return std::nullopt;
    return CurvePlace{*curve, view_.mapping().toDocument(pixel_)};
}

void Gestures::startDrag() {
    view_.setGhost(std::nullopt);
    switch (beginDrag(press_, view_, client_)) {
    case DragKind::none:
        return setState(State::idle);
    case DragKind::drag:
        return setState(State::dragging);
    case DragKind::band:
        return setState(State::banding);
    }
}

void Gestures::cancel() {
    const State was = state_;
    setState(State::idle);
    if (was == State::dragging)
        client_.cancelDrag();
    else if (was == State::banding)
        view_.setRubberBand(std::nullopt);
}

void Gestures::finish() {
    const State was = state_;
    setState(State::idle);
    if (was == State::dragging)
        client_.endDrag();
    else if (was == State::banding)
        finishBand();
}

void Gestures::finishBand() {
    const Selection inside = view_.pointsIn(band());
    view_.setRubberBand(std::nullopt);
    const bool isShift = press_.with(Qt::ShiftModifier);
    const bool isSubtracting = press_.with(Qt::AltModifier) || (isShift && press_.with(Qt::ControlModifier));
    if (isSubtracting)
        client_.select(without(view_.selection(), inside));
    else
        client_.select(isShift ? united(view_.selection(), inside) : inside);
}

QRectF Gestures::band() const {
    // Its first corner stays where it is in the document while the view scrolls.
    return QRectF(view_.mapping().toPixels(press_.at), pixel_).normalized();
}

void Gestures::setState(State state) {
    state_ = state;
    showCursor();
}

void Gestures::showCursor() {
    Qt::CursorShape shape = view_.tool() == Tool::add ? Qt::CrossCursor : Qt::ArrowCursor;
    if (state_ == State::panning)
        shape = Qt::ClosedHandCursor;
    else if (isSpaceHeld_ && state_ == State::idle)
        shape = Qt::OpenHandCursor;
    view_.viewport()->setCursor(shape);
}

} // namespace kriva::ui
