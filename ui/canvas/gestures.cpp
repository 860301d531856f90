#include "ui/canvas/gestures.h"

#include "ui/canvas/canvas_view.h"
#include "ui/canvas/qt_geometry.h"

#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>

namespace kriva::ui {
namespace {

constexpr double kClickReach = 4;      ///< pixels: less movement is a click
constexpr double kNotchAngle = 120;    ///< of a wheel, in eighths of a degree
constexpr double kPixelsPerNotch = 60; ///< three lines, as elsewhere

[[nodiscard]] bool isHandle(GripKind kind) {
    return kind == GripKind::inHandle || kind == GripKind::outHandle || kind == GripKind::startDerivative ||
           kind == GripKind::endDerivative;
}

[[nodiscard]] Vector lockedToAxis(Vector way) {
    return std::abs(way.x) >= std::abs(way.y) ? Vector{way.x, 0} : Vector{0, way.y};
}

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
    if (state_ == State::dragging)
        client_.drag(way(modifiers), modifiers);
    else if (state_ == State::banding)
        view_.setRubberBand(band());
    else if (state_ == State::idle && isPointerInside_)
        view_.hover(pixel_, modifiers);
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
    isSpaceHeld_ = isHeld;
    showCursor();
}

void Gestures::startDrag() {
    const bool isAlt = press_.with(Qt::AltModifier);
    const bool isShift = press_.with(Qt::ShiftModifier);
    if (press_.button == Qt::RightButton) {
        setState(State::idle);
    } else if (press_.under.grip && !isAlt) {
        takeGrip(*press_.under.grip);
    } else if (isAlt || isShift) {
        setState(State::banding);
    } else if (press_.under.curve) {
        setState(State::dragging);
        client_.beginCurveDrag(*press_.under.curve, press_.at);
    } else if (view_.tool() == Tool::add) {
        setState(State::dragging);
        client_.beginAddDrag(press_.at);
    } else {
        setState(State::banding);
    }
}

void Gestures::takeGrip(const GripRef& grip) {
    setState(State::dragging);
    const Selection& selection = view_.selection();
    if (!selection.contains(grip)) {
        const bool isAdding = press_.with(Qt::ShiftModifier);
        client_.select(isAdding ? united(selection, {grip}) : Selection{grip});
    }
    client_.beginDrag(grip);
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

Vector Gestures::way(Qt::KeyboardModifiers modifiers) const {
    const Vector way = view_.mapping().toDocument(pixel_) - press_.at;
    const bool isLocked =
        modifiers.testFlag(Qt::ControlModifier) && press_.under.grip && !isHandle(press_.under.grip->id.kind);
    return isLocked ? lockedToAxis(way) : way;
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
