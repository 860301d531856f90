#include "core/document/limit_check.h"
#include "ui/document/open_document.h"

#include <utility>

namespace kriva::ui {
namespace {

/// An initializer list would copy the curve.
[[nodiscard]] std::vector<CurveExchange> only(CurveExchange one) {
    std::vector<CurveExchange> list;
    list.push_back(std::move(one));
    return list;
}

} // namespace

bool OpenDocument::change(SheetIndex sheet, Serial serial, Curve curve, const StepLabel& label) {
    beginGesture(sheet, serial, label);
    preview(std::move(curve));
    const bool isChanged = gesture_ && gesture_->start; // by a single preview, which shows no equal value
    endGesture();
    return isChanged;
}

std::optional<Serial> OpenDocument::add(SheetIndex sheet, int index, Curve curve, const StepLabel& label) {
    const std::optional<Serial> serial = beginGestureWithNew(sheet, index, std::move(curve), label);
    endGesture();
    return serial;
}

bool OpenDocument::divide(SheetIndex sheet, Serial serial, Curve first, Curve second, const StepLabel& label) {
    endGesture();
    const std::optional<int> index = indexOf(sheet, serial);
    if (!index)
        return false;
    Sheet divided = this->sheet(sheet);
    divided.curves[static_cast<std::size_t>(*index)] = first;
    if (!isWithinLimits(divided, {}, second))
        return false;
    std::vector<CurveExchange> halves;
    halves.push_back({serial, PlacedCurve{std::move(first), *index}});
    halves.push_back({newSerial(), PlacedCurve{std::move(second), *index + 1}});
    push(sheet, exchange(sheet, std::move(halves)), label);
    setActiveCurve(sheet, serial);
    return true;
}

bool OpenDocument::addAll(SheetIndex sheet, std::vector<Curve> curves, const StepLabel& label) {
    endGesture();
    for (const Curve& curve : curves)
        if (!isWithinLimits({}, {}, curve))
            return false;
    Sheet together = this->sheet(sheet);
    together.curves.insert(together.curves.end(), curves.begin(), curves.end());
    if (const std::optional<FileError> error = sheetLimitError(together)) {
        Q_EMIT refused(*error);
        return false;
    }
    std::vector<CurveExchange> added;
    int index = static_cast<int>(serials(sheet).size());
    for (Curve& curve : curves)
        added.push_back({newSerial(), PlacedCurve{std::move(curve), index++}});
    const Serial last = added.empty() ? 0 : added.back().serial;
    push(sheet, exchange(sheet, std::move(added)), label);
    setActiveCurve(sheet, last);
    return true;
}

void OpenDocument::remove(SheetIndex sheet, Serial serial, const StepLabel& label) {
    endGesture();
    if (find(sheet, serial))
        push(sheet, exchange(sheet, only({serial, std::nullopt})), label);
}

void OpenDocument::reorder(SheetIndex sheet, Serial serial, int index, const StepLabel& label) {
    endGesture();
    const Curve* curve = find(sheet, serial);
    if (curve && *indexOf(sheet, serial) != index)
        push(sheet, exchange(sheet, only({serial, PlacedCurve{*curve, index}})), label);
}

void OpenDocument::beginGesture(SheetIndex sheet, Serial serial, const StepLabel& label) {
    endGesture();
    if (find(sheet, serial))
        gesture_ = Gesture{sheet, serial, label};
}

std::optional<Serial> OpenDocument::beginGestureWithNew(SheetIndex sheet, int index, Curve curve,
                                                        const StepLabel& label) {
    endGesture();
    if (!isWithinLimits(this->sheet(sheet), {}, curve))
        return {};
    const Serial serial = newSerial();
    gesture_ = Gesture{.sheet = sheet, .serial = serial, .label = label, .isNew = true};
    exchange(sheet, only({serial, PlacedCurve{std::move(curve), index}}));
    setActiveCurve(sheet, serial);
    return serial;
}

void OpenDocument::preview(Curve curve) {
    if (!gesture_ || curve == *find(gesture_->sheet, gesture_->serial) ||
        !isWithinLimits(sheet(gesture_->sheet), indexOf(gesture_->sheet, gesture_->serial), curve))
        return;
    Curve before = put(gesture_->sheet, gesture_->serial, std::move(curve));
    if (!gesture_->start)
        gesture_->start = std::move(before);
    Q_EMIT curveChanged(gesture_->sheet, gesture_->serial);
}

const Curve& OpenDocument::gestureStart() const {
    return gesture_->start ? *gesture_->start : *find(gesture_->sheet, gesture_->serial);
}

void OpenDocument::endGesture() {
    burstEnd_.stop();
    if (!gesture_)
        return;
    Gesture gesture = *std::exchange(gesture_, std::nullopt);
    const int index = *indexOf(gesture.sheet, gesture.serial);
    if (gesture.isNew)
        push(gesture.sheet, only({gesture.serial, std::nullopt}), gesture.label);
    else if (gesture.start && *find(gesture.sheet, gesture.serial) != *gesture.start)
        push(gesture.sheet, only({gesture.serial, PlacedCurve{std::move(*gesture.start), index}}), gesture.label);
}

void OpenDocument::cancelGesture() {
    burstEnd_.stop();
    if (!gesture_)
        return;
    Gesture gesture = *std::exchange(gesture_, std::nullopt);
    if (gesture.isNew) {
        exchange(gesture.sheet, only({gesture.serial, std::nullopt}));
    } else if (gesture.start && *find(gesture.sheet, gesture.serial) != *gesture.start) {
        put(gesture.sheet, gesture.serial, std::move(*gesture.start));
        Q_EMIT curveChanged(gesture.sheet, gesture.serial);
    }
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

bool OpenDocument::isWithinLimits(const Sheet& present, std::optional<int> replacedIndex, const Curve& curve) {
    const auto replaced = replacedIndex ? std::optional(static_cast<std::size_t>(*replacedIndex)) : std::nullopt;
    const std::optional<FileError> error = limitErrorWith(present, replaced, curve);
    if (error)
        Q_EMIT refused(*error);
    return !error;
}

} // namespace kriva::ui
