#include "ui/document/open_document.h"

#include "core/document/limit_check.h"

#include <algorithm>

namespace kriva::ui {
namespace {

constexpr int kHistoryLimit = 500;
constexpr int kBurstPause = 800; // ms without a further key or turn of the wheel that end a burst

std::ptrdiff_t offset(int index) {
    return static_cast<std::ptrdiff_t>(index);
}

} // namespace

OpenDocument::OpenDocument(QObject* parent)
    : QObject(parent) {
    for (QUndoStack*& history : histories_) {
        history = new QUndoStack(&group_);
        history->setUndoLimit(kHistoryLimit);
    }
    group_.setActiveStack(histories_[value_.active]);
    burstEnd_.setSingleShot(true);
    burstEnd_.setInterval(kBurstPause);
    connect(&burstEnd_, &QTimer::timeout, this, &OpenDocument::endGesture);
}

OpenDocument::~OpenDocument() = default;

std::optional<int> OpenDocument::indexOf(SheetIndex sheet, Serial serial) const {
    const auto& serials = serials_[sheet];
    const auto found = std::find(serials.begin(), serials.end(), serial);
    if (found == serials.end())
        return {};
    return static_cast<int>(found - serials.begin());
}

const Curve* OpenDocument::find(SheetIndex sheet, Serial serial) const {
    const std::optional<int> index = indexOf(sheet, serial);
    return index ? &value_.sheets[sheet].curves[static_cast<std::size_t>(*index)] : nullptr;
}

Serial OpenDocument::activeCurve(SheetIndex sheet) const {
    const auto& serials = serials_[sheet];
    return serials.empty() ? 0 : serials[static_cast<std::size_t>(value_.sheets[sheet].view.activeCurve)];
}

void OpenDocument::replace(Document document) {
    cancelGesture();
    value_ = std::move(document);
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        histories_[sheet]->clear();
        serials_[sheet].clear();
        for (std::size_t i = 0; i < value_.sheets[sheet].curves.size(); ++i)
            serials_[sheet].push_back(++lastSerial_);
    }
    group_.setActiveStack(histories_[value_.active]);
    markSaved();
    Q_EMIT replaced();
}

bool OpenDocument::isModified() const {
    return !sameContent(value_, saved_);
}

void OpenDocument::markSaved() {
    endGesture();
    saved_ = value_;
    tellModified();
}

void OpenDocument::tellModified() {
    const bool isNow = isModified();
    if (isNow == wasModified_)
        return;
    wasModified_ = isNow;
    Q_EMIT modifiedChanged(isNow);
}

bool OpenDocument::change(SheetIndex sheet, Serial serial, Curve curve, const StepLabel& label) {
    beginGesture(sheet, serial, label);
    preview(std::move(curve));
    const bool isChanged = gesture_ && *find(sheet, serial) != gesture_->start;
    endGesture();
    return isChanged;
}

std::optional<Serial> OpenDocument::add(SheetIndex sheet, int index, Curve curve, const StepLabel& label) {
    const std::optional<Serial> serial = beginGestureWithNew(sheet, index, std::move(curve), label);
    endGesture();
    return serial;
}

void OpenDocument::remove(SheetIndex sheet, Serial serial, const StepLabel& label) {
    endGesture();
    if (find(sheet, serial))
        push(sheet, serial, exchange(sheet, serial, std::nullopt), label);
}

void OpenDocument::reorder(SheetIndex sheet, Serial serial, int index, const StepLabel& label) {
    endGesture();
    const Curve* curve = find(sheet, serial);
    if (curve && *indexOf(sheet, serial) != index)
        push(sheet, serial, exchange(sheet, serial, PlacedCurve{*curve, index}), label);
}

void OpenDocument::beginGesture(SheetIndex sheet, Serial serial, const StepLabel& label) {
    endGesture();
    if (const Curve* curve = find(sheet, serial))
        gesture_ = Gesture{sheet, serial, label, *curve};
}

std::optional<Serial> OpenDocument::beginGestureWithNew(SheetIndex sheet, int index, Curve curve,
                                                        const StepLabel& label) {
    endGesture();
    if (!isWithinLimits(sheet, {}, curve))
        return {};
    const Serial serial = ++lastSerial_;
    gesture_ = Gesture{sheet, serial, label, curve, true};
    exchange(sheet, serial, PlacedCurve{std::move(curve), index});
    setActiveCurve(sheet, serial);
    return serial;
}

void OpenDocument::preview(Curve curve) {
    if (!gesture_)
        return;
    const int index = *indexOf(gesture_->sheet, gesture_->serial);
    if (curve == value_.sheets[gesture_->sheet].curves[static_cast<std::size_t>(index)] ||
        !isWithinLimits(gesture_->sheet, index, curve))
        return;
    put(gesture_->sheet, index, std::move(curve));
}

void OpenDocument::endGesture() {
    burstEnd_.stop();
    if (!gesture_)
        return;
    const Gesture gesture = *std::exchange(gesture_, std::nullopt);
    const int index = *indexOf(gesture.sheet, gesture.serial);
    if (gesture.isNew)
        push(gesture.sheet, gesture.serial, std::nullopt, gesture.label);
    else if (value_.sheets[gesture.sheet].curves[static_cast<std::size_t>(index)] != gesture.start)
        push(gesture.sheet, gesture.serial, PlacedCurve{gesture.start, index}, gesture.label);
}

void OpenDocument::cancelGesture() {
    burstEnd_.stop();
    if (!gesture_)
        return;
    Gesture gesture = *std::exchange(gesture_, std::nullopt);
    const int index = *indexOf(gesture.sheet, gesture.serial);
    if (gesture.isNew)
        exchange(gesture.sheet, gesture.serial, std::nullopt);
    else if (value_.sheets[gesture.sheet].curves[static_cast<std::size_t>(index)] != gesture.start)
        put(gesture.sheet, index, std::move(gesture.start));
}

void OpenDocument::changeInBurst(SheetIndex sheet, Serial serial, Curve curve, const StepLabel& label) {
    const bool goesOn = gesture_ && gesture_->isBurst && gesture_->sheet == sheet && gesture_->serial == serial &&
                        gesture_->label == label;
    if (!goesOn) {
        beginGesture(sheet, serial, label);
        if (!gesture_)
            return;
        gesture_->isBurst = true;
    }
    preview(std::move(curve));
    burstEnd_.start();
}

void OpenDocument::put(SheetIndex sheet, int index, Curve curve) {
    value_.sheets[sheet].curves[static_cast<std::size_t>(index)] = std::move(curve);
    Q_EMIT curveChanged(sheet, serials_[sheet][static_cast<std::size_t>(index)]);
}

void OpenDocument::push(SheetIndex sheet, Serial serial, std::optional<PlacedCurve> other, const StepLabel& label) {
    histories_[sheet]->push(new SwapCurve(*this, sheet, serial, std::move(other), stored(label)));
    tellModified();
}

std::optional<PlacedCurve> OpenDocument::exchange(SheetIndex sheet, Serial serial, std::optional<PlacedCurve> other) {
    auto& curves = value_.sheets[sheet].curves;
    auto& serials = serials_[sheet];
    const Serial active = activeCurve(sheet);
    const std::optional<int> index = indexOf(sheet, serial);
    std::optional<PlacedCurve> before;
    if (index)
        before = PlacedCurve{curves[static_cast<std::size_t>(*index)], *index};
    if (before && other) // whether a curve is shown is not undone
        other->curve = withView(std::move(other->curve), viewOf(before->curve));
    if (before && other && before->index == other->index) {
        put(sheet, *index, std::move(other->curve));
    } else {
        if (index) {
            curves.erase(curves.begin() + offset(*index));
            serials.erase(serials.begin() + offset(*index));
        }
        if (other) {
            curves.insert(curves.begin() + offset(other->index), std::move(other->curve));
            serials.insert(serials.begin() + offset(other->index), serial);
        }
        keepActiveCurve(sheet, active);
        Q_EMIT curvesChanged(sheet);
    }
    return before;
}

void OpenDocument::keepActiveCurve(SheetIndex sheet, Serial serial) {
    int& active = value_.sheets[sheet].view.activeCurve;
    const int last = std::max(0, static_cast<int>(serials_[sheet].size()) - 1);
    active = indexOf(sheet, serial).value_or(std::min(active, last));
}

bool OpenDocument::isWithinLimits(SheetIndex sheet, std::optional<int> replacedIndex, const Curve& curve) {
    const auto replaced = replacedIndex ? std::optional(static_cast<std::size_t>(*replacedIndex)) : std::nullopt;
    const std::optional<FileError> error = limitErrorWith(value_.sheets[sheet], sheet, replaced, curve);
    if (error)
        Q_EMIT refused(*error);
    return !error;
}

void OpenDocument::setActiveSheet(SheetIndex sheet) {
    if (value_.active == sheet)
        return;
    endGesture();
    value_.active = sheet;
    group_.setActiveStack(histories_[sheet]);
    Q_EMIT activeSheetChanged(sheet);
}

void OpenDocument::setActiveCurve(SheetIndex sheet, Serial serial) {
    const std::optional<int> index = indexOf(sheet, serial);
    if (!index || value_.sheets[sheet].view.activeCurve == *index)
        return;
    value_.sheets[sheet].view.activeCurve = *index;
    Q_EMIT viewChanged(sheet);
}

void OpenDocument::setCurveShown(SheetIndex sheet, Serial serial, bool isShown) {
    endGesture();
    const std::optional<int> index = indexOf(sheet, serial);
    if (!index)
        return;
    Curve& curve = value_.sheets[sheet].curves[static_cast<std::size_t>(*index)];
    CurveView view = viewOf(curve);
    if (view.isShown == isShown)
        return;
    view.isShown = isShown;
    put(sheet, *index, withView(curve, view));
}

void OpenDocument::setLayerShown(SheetIndex sheet, std::string_view layer, bool isShown) {
    value_.sheets[sheet].view.layers[std::string(layer)] = isShown;
    Q_EMIT viewChanged(sheet);
}

void OpenDocument::undo() {
    endGesture();
    group_.undo();
    tellModified();
}

void OpenDocument::redo() {
    endGesture();
    group_.redo();
    tellModified();
}

void OpenDocument::goToStep(SheetIndex sheet, int step) {
    endGesture();
    histories_[sheet]->setIndex(step);
    tellModified();
}

} // namespace kriva::ui
