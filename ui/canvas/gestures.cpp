#include "ui/canvas/gestures.h"

#include "ui/canvas/base/qt_geometry.h"
#include "ui/canvas/canvas_view.h"

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

Gestures::Gestures(CanvasView& view, CanvasInput& input)
    : view_(view)
    , input_(input) {}

void Gestures::press(const QMouseEvent& event) {
    pixel_ = event.position();
    if (isRunning()) {
        if (event.button() == Qt::RightButton)
            cancel();
    } else if (event.button() & (Qt::LeftButton | Qt::MiddleButton | Qt::RightButton)) {
        press_ = eventAt(pixel_, event.button(), event.modifiers());
        const bool isPanning = press_.button == Qt::MiddleButton || (press_.button == Qt::LeftButton && isSpaceHeld_);
        setState(isPanning ? State::panning : State::pressed);
    }
}

PointerEvent Gestures::eventAt(QPointF pixel, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) const {
    return {pixel, view_.mapping().toDocument(pixel), button, modifiers, view_.scene().hitAt(pixel)};
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
        input_.drag(view_.mapping().toDocument(pixel_) - press_.at, {modifiers, isSpaceHeld_});
    else if (state_ == State::banding)
        view_.scene().setRubberBand(band());
    else
        lookAgain();
}

void Gestures::lookAgain() {
    if (state_ != State::idle || !isPointerInside_)
        return;
    const PointerEvent now = eventAt(pixel_, Qt::NoButton, modifiers_);
    view_.scene().setHovered(now.under.grip);
    input_.hover(now);
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
    view_.scene().setHovered(std::nullopt);
    view_.scene().setSnap(std::nullopt);
    view_.scene().setGhost(std::nullopt);
}

void Gestures::release(const QMouseEvent& event) {
    pixel_ = event.position();
    if (!isRunning() || event.button() != press_.button)
        return;
    if (state_ == State::pressed) {
        setState(State::idle);
        input_.click(press_);
    } else {
        finish();
    }
    follow(event.modifiers());
}

void Gestures::doubleClick(const QMouseEvent& event) {
    const bool isDone = !isRunning() && !isSpaceHeld_ &&
                        input_.doubleClick(eventAt(event.position(), event.button(), event.modifiers()));
    if (!isDone)
        press(event);
}

void Gestures::setSpaceHeld(bool isHeld) {
    if (std::exchange(isSpaceHeld_, isHeld) == isHeld)
        return;
    showCursor();
    if (state_ == State::dragging)
        follow(modifiers_);
}

std::optional<CurvePlace> Gestures::curveUnderPointer() const {
    const std::optional<Serial> curve = isPointerInside_ ? view_.scene().hitAt(pixel_).curve : std::nullopt;
    if (!curve)
        return std::nullopt;
    return CurvePlace{*curve, view_.mapping().toDocument(pixel_)};
}

void Gestures::startDrag() {
    view_.scene().setGhost(std::nullopt);
    if (press_.button == Qt::RightButton)
        setState(State::idle);
    else
        setState(input_.beginDrag(press_) ? State::dragging : State::banding);
}

void Gestures::cancel() {
    const State was = state_;
    setState(State::idle);
    if (was == State::dragging)
        input_.cancelDrag();
    else if (was == State::banding)
        view_.scene().setRubberBand(std::nullopt);
}

void Gestures::finish() {
    const State was = state_;
    setState(State::idle);
    if (was == State::dragging)
        input_.endDrag();
    else if (was == State::banding)
        finishBand();
}

void Gestures::finishBand() {
    const Selection inside = view_.scene().pointsIn(band());
    view_.scene().setRubberBand(std::nullopt);
    const bool isShift = press_.with(Qt::ShiftModifier);
    const bool isSubtracting = press_.with(Qt::AltModifier) || (isShift && press_.with(Qt::ControlModifier));
    if (isSubtracting)
        input_.select(without(view_.scene().selection(), inside));
    else
        input_.select(isShift ? united(view_.scene().selection(), inside) : inside);
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
