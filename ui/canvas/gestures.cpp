#include "ui/canvas/gestures.h"

#include "ui/canvas/canvas_view.h"
#include "ui/canvas/qt_geometry.h"

#include <QMouseEvent>

#include <cmath>

namespace kriva::ui {
namespace {

constexpr double kClickReach = 4; ///< pixels: less movement is a click

[[nodiscard]] bool isHandle(GripKind kind) {
    return kind == GripKind::inHandle || kind == GripKind::outHandle || kind == GripKind::startDerivative ||
           kind == GripKind::endDerivative;
}

[[nodiscard]] Vector lockedToAxis(Vector way) {
    return std::abs(way.x) >= std::abs(way.y) ? Vector{way.x, 0} : Vector{0, way.y};
}

[[nodiscard]] Selection without(Selection selection, const Selection& removed) {
    std::erase_if(selection, [&](const GripRef& grip) { return removed.contains(grip); });
    return selection;
}

[[nodiscard]] Selection with(Selection selection, Selection added) {
    selection.merge(added);
    return selection;
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
    press_ = {pixel_, view_.mapping().toDocument(pixel_), event.button(), event.modifiers(), view_.hitAt(pixel_)};
    const bool isPanning = event.button() == Qt::MiddleButton || (event.button() == Qt::LeftButton && isSpaceHeld_);
    setState(isPanning ? State::panning : State::pressed);
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

void Gestures::leave() {
    isPointerInside_ = false;
}

void Gestures::release(const QMouseEvent& event) {
    pixel_ = event.position();
    if (!isRunning() || event.button() != press_.button)
        return;
    if (state_ == State::pressed) {
        setState(State::idle);
        click();
    } else {
        finish();
    }
    follow(event.modifiers());
}

void Gestures::doubleClick(const QMouseEvent& event) {
    pixel_ = event.position();
    const bool isPlain = event.button() == Qt::LeftButton && event.modifiers() == Qt::NoModifier;
    const Hit under = view_.hitAt(pixel_);
    // Elsewhere the second press is one more click.
    if (isRunning() || !isPlain || isSpaceHeld_ || view_.tool() == Tool::add || under.grip) {
        press(event);
        return;
    }
    const Point at = view_.mapping().toDocument(pixel_);
    if (under.curve)
        client_.insertPoint(*under.curve, at);
    else
        client_.addPoint(at);
}

void Gestures::setSpaceHeld(bool isHeld) {
    isSpaceHeld_ = isHeld;
    showCursor();
}

void Gestures::click() {
    if (press_.button == Qt::RightButton)
        view_.requestContextMenu(press_.pixel);
    else if (press_.modifiers.testFlag(Qt::AltModifier))
        clickWithAlt();
    else if (view_.tool() == Tool::add)
        clickWithAddTool();
    else
        clickWithEditTool();
}

void Gestures::clickWithAlt() {
    if (press_.modifiers.testFlag(Qt::ControlModifier)) {
        if (press_.under.curve)
            client_.insertPoint(*press_.under.curve, press_.at);
    } else if (press_.under.grip) {
        client_.removePoint(*press_.under.grip);
    } else {
        client_.addPoint(press_.at);
    }
}

void Gestures::clickWithAddTool() {
    if (press_.under.grip)
        client_.addPointOn(*press_.under.grip, press_.at);
    else if (press_.under.curve)
        client_.insertPoint(*press_.under.curve, press_.at);
    else
        client_.addPoint(press_.at);
}

void Gestures::clickWithEditTool() {
    const bool isToggling = press_.modifiers.testFlag(Qt::ShiftModifier);
    if (const auto& grip = press_.under.grip) {
        const Selection& selection = view_.selection();
        if (!isToggling)
            client_.select({*grip});
        else
            client_.select(selection.contains(*grip) ? without(selection, {*grip}) : with(selection, {*grip}));
    } else if (press_.under.curve) {
        client_.activateCurve(*press_.under.curve);
    } else if (!isToggling && !view_.selection().empty()) {
        client_.select({});
    }
}

void Gestures::startDrag() {
    const bool isAlt = press_.modifiers.testFlag(Qt::AltModifier);
    const bool isShift = press_.modifiers.testFlag(Qt::ShiftModifier);
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
        const bool isAdding = press_.modifiers.testFlag(Qt::ShiftModifier);
        client_.select(isAdding ? with(selection, {grip}) : Selection{grip});
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
    const bool isShift = press_.modifiers.testFlag(Qt::ShiftModifier);
    const bool isSubtracting =
        press_.modifiers.testFlag(Qt::AltModifier) || (isShift && press_.modifiers.testFlag(Qt::ControlModifier));
    if (isSubtracting)
        client_.select(without(view_.selection(), inside));
    else
        client_.select(isShift ? with(view_.selection(), inside) : inside);
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
