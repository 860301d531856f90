#include "ui/document/open_document.h"

#include "core/document/limit_check.h"

#include <algorithm>
#include <utility>

namespace kriva::ui {
namespace {

constexpr int kHistoryLimit = 500;
constexpr int kBurstPause = 800; // ms without a further key or turn of the wheel that end a burst

} // namespace

OpenDocument::OpenDocument(QObject* parent)
    : QObject(parent) {
    for (QUndoStack*& history : histories_) {
        history = new QUndoStack(&group_);
        history->setUndoLimit(kHistoryLimit);
    }
    group_.setActiveStack(histories_[value().active]);
    burstEnd_.setSingleShot(true);
    burstEnd_.setInterval(kBurstPause);
    connect(&burstEnd_, &QTimer::timeout, this, &OpenDocument::endGesture);
}

OpenDocument::~OpenDocument() = default;

void OpenDocument::replace(Document document) {
    cancelGesture();
    present_.replace(std::move(document));
    for (QUndoStack* history : histories_)
        history->clear();
    group_.setActiveStack(histories_[value().active]);
    markSaved();
    Q_EMIT replaced();
}

bool OpenDocument::isModified() const {
    return !saved_ || !sameContent(value(), *saved_);
}

void OpenDocument::markSaved() {
    endGesture();
    saved_ = value();
    tellModified();
}

void OpenDocument::markUnsaved() {
    saved_.reset();
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
    push(sheet,
         exchange(sheet, {{serial, PlacedCurve{std::move(first), *index}},
                          {present_.newSerial(), PlacedCurve{std::move(second), *index + 1}}}),
         label);
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
        added.push_back({present_.newSerial(), PlacedCurve{std::move(curve), index++}});
    const Serial last = added.empty() ? 0 : added.back().serial;
    push(sheet, exchange(sheet, std::move(added)), label);
    setActiveCurve(sheet, last);
    return true;
}

void OpenDocument::remove(SheetIndex sheet, Serial serial, const StepLabel& label) {
    endGesture();
    if (find(sheet, serial))
        push(sheet, exchange(sheet, {{serial, std::nullopt}}), label);
}

void OpenDocument::reorder(SheetIndex sheet, Serial serial, int index, const StepLabel& label) {
    endGesture();
    const Curve* curve = find(sheet, serial);
    if (curve && *indexOf(sheet, serial) != index)
        push(sheet, exchange(sheet, {{serial, PlacedCurve{*curve, index}}}), label);
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
    const Serial serial = present_.newSerial();
    gesture_ = Gesture{.sheet = sheet, .serial = serial, .label = label, .isNew = true};
    exchange(sheet, serial, PlacedCurve{std::move(curve), index});
    setActiveCurve(sheet, serial);
    return serial;
}

void OpenDocument::preview(Curve curve) {
    if (!gesture_ || curve == *find(gesture_->sheet, gesture_->serial) ||
        !isWithinLimits(sheet(gesture_->sheet), indexOf(gesture_->sheet, gesture_->serial), curve))
        return;
    Curve before = present_.put(gesture_->sheet, gesture_->serial, std::move(curve));
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
        push(gesture.sheet, {{gesture.serial, std::nullopt}}, gesture.label);
    else if (gesture.start && *find(gesture.sheet, gesture.serial) != *gesture.start)
        push(gesture.sheet, {{gesture.serial, PlacedCurve{std::move(*gesture.start), index}}}, gesture.label);
}

void OpenDocument::cancelGesture() {
    burstEnd_.stop();
    if (!gesture_)
        return;
    Gesture gesture = *std::exchange(gesture_, std::nullopt);
    if (gesture.isNew)
        exchange(gesture.sheet, gesture.serial, std::nullopt);
    else if (gesture.start && *find(gesture.sheet, gesture.serial) != *gesture.start)
        put(gesture.sheet, gesture.serial, std::move(*gesture.start));
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

void OpenDocument::put(SheetIndex sheet, Serial serial, Curve curve) {
    present_.put(sheet, serial, std::move(curve));
    Q_EMIT curveChanged(sheet, serial);
}

void OpenDocument::push(SheetIndex sheet, std::vector<CurveExchange> others, const StepLabel& label) {
    histories_[sheet]->push(new SwapCurves(*this, sheet, std::move(others), stored(label)));
    tellModified();
}

std::optional<PlacedCurve> OpenDocument::exchange(SheetIndex sheet, Serial serial, std::optional<PlacedCurve> other) {
    const int newIndex = other ? other->index : -1;
    std::optional<PlacedCurve> before = present_.exchange(sheet, serial, std::move(other));
    if (before && before->index == newIndex)
        Q_EMIT curveChanged(sheet, serial);
    else
        Q_EMIT curvesChanged(sheet);
    return before;
}

std::vector<CurveExchange> OpenDocument::exchange(SheetIndex sheet, std::vector<CurveExchange> others) {
    if (others.size() == 1)
        return {{others[0].serial, exchange(sheet, others[0].serial, std::move(others[0].other))}};
    std::vector<Serial> changed;
    for (CurveExchange& one : others) {
        const bool stays = one.other && indexOf(sheet, one.serial) == one.other->index;
        one.other = present_.exchange(sheet, one.serial, std::move(one.other));
        if (stays)
            changed.push_back(one.serial);
    }
    for (const Serial serial : changed)
        Q_EMIT curveChanged(sheet, serial);
    Q_EMIT curvesChanged(sheet);
    std::ranges::reverse(others); // the last change is the first to be taken back
    return others;
}

bool OpenDocument::isWithinLimits(const Sheet& present, std::optional<int> replacedIndex, const Curve& curve) {
    const auto replaced = replacedIndex ? std::optional(static_cast<std::size_t>(*replacedIndex)) : std::nullopt;
    const std::optional<FileError> error = limitErrorWith(present, replaced, curve);
    if (error)
        Q_EMIT refused(*error);
    return !error;
}

void OpenDocument::setActiveSheet(SheetIndex sheet) {
    if (value().active == sheet)
        return;
    endGesture();
    present_.setActiveSheet(sheet);
    group_.setActiveStack(histories_[sheet]);
    Q_EMIT activeSheetChanged(sheet);
}

void OpenDocument::setActiveCurve(SheetIndex sheet, Serial serial) {
    const std::optional<int> index = indexOf(sheet, serial);
    if (!index || present_.view(sheet).activeCurve == *index)
        return;
    present_.view(sheet).activeCurve = *index;
    Q_EMIT viewChanged(sheet);
}

void OpenDocument::setCurveShown(SheetIndex sheet, Serial serial, bool isShown) {
    endGesture();
    const Curve* curve = find(sheet, serial);
    if (!curve || viewOf(*curve).isShown == isShown)
        return;
    CurveView view = viewOf(*curve);
    view.isShown = isShown;
    put(sheet, serial, withView(*curve, view));
}

void OpenDocument::setLayerShown(SheetIndex sheet, std::string_view layer, bool isShown) {
    present_.view(sheet).layers[std::string(layer)] = isShown;
    Q_EMIT viewChanged(sheet);
}

void OpenDocument::setViewNumbers(SheetIndex sheet, const ViewSetting& setting, std::vector<double> numbers) {
    SheetView view = withNumbers(present_.view(sheet), setting, std::move(numbers));
    if (view == present_.view(sheet))
        return;
    present_.view(sheet) = std::move(view);
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
