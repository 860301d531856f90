#include "ui/document/open_document.h"

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
    SerialDocument::replace(std::move(document));
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

void OpenDocument::push(SheetIndex sheet, std::vector<CurveExchange> others, const StepLabel& label) {
    histories_[sheet]->push(new SwapCurves(*this, sheet, std::move(others), stored(label)));
    tellModified();
}

std::vector<CurveExchange> OpenDocument::exchange(SheetIndex sheet, std::vector<CurveExchange> others) {
    std::vector<Serial> changed;
    for (CurveExchange& one : others) {
        const bool stays = one.other && indexOf(sheet, one.serial) == one.other->index;
        one.other = SerialDocument::exchange(sheet, one.serial, std::move(one.other));
        if (stays)
            changed.push_back(one.serial);
    }
    for (const Serial serial : changed)
        Q_EMIT curveChanged(sheet, serial);
    if (changed.size() < others.size())
        Q_EMIT curvesChanged(sheet);
    std::ranges::reverse(others); // the last change is the first to be taken back
    return others;
}

void OpenDocument::setActiveSheet(SheetIndex sheet) {
    if (value().active == sheet)
        return;
    endGesture();
    SerialDocument::setActiveSheet(sheet);
    group_.setActiveStack(histories_[sheet]);
    Q_EMIT activeSheetChanged(sheet);
}

void OpenDocument::setActiveCurve(SheetIndex sheet, Serial serial) {
    const std::optional<int> index = indexOf(sheet, serial);
    if (!index || view(sheet).activeCurve == *index)
        return;
    view(sheet).activeCurve = *index;
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
    Q_EMIT curveChanged(sheet, serial);
}

void OpenDocument::setLayerShown(SheetIndex sheet, std::string_view layer, bool isShown) {
    view(sheet).layers[std::string(layer)] = isShown;
    Q_EMIT viewChanged(sheet);
}

void OpenDocument::setViewNumbers(SheetIndex sheet, const ViewSetting& setting, std::vector<double> numbers) {
    SheetView changed = withNumbers(view(sheet), setting, std::move(numbers));
    if (changed == view(sheet))
        return;
    view(sheet) = std::move(changed);
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
