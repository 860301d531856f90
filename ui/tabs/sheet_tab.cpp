#include "ui/tabs/sheet_tab.h"

#include "ui/editing/hints/hint_text.h"
#include "ui/editing/pointing.h"

#include <QEvent>

namespace kriva::ui {

SheetTab::SheetTab(OpenDocument& document, QThreadPool& workers, SheetIndex sheet, const SheetUi& ui, QWidget* parent)
    : QMainWindow(parent)
    , editor_(document, workers, sheet)
    , canvas_(new CanvasView(*this, this))
    , content_(editor_, relations_, *canvas_)
    , ruled_(new RuledCanvas(canvas_, this))
    , panels_(*this, editor_, relations_, ui)
    , actions_(editor_, ui, *canvas_) {
    setWindowFlags(Qt::Widget); // a main window inside another: for its docks only
    setDockNestingEnabled(true);
    setCentralWidget(ruled_);

    connect(&editor_, &SheetEditor::hint, this, [this](const Hint& hint) { Q_EMIT told(hint.text()); });
    connect(&editor_, &SheetEditor::drawingBegun, canvas_, [this] { canvas_->setTool(Tool::add); });
    retranslateUi();
}

void SheetTab::setVisible(bool isVisible) {
    if (isVisible)
        panels_.make();
    QMainWindow::setVisible(isVisible);
}

void SheetTab::showEvent(QShowEvent* event) {
    panels_.setTabShown(true);
    QMainWindow::showEvent(event);
}

void SheetTab::hideEvent(QHideEvent* event) {
    panels_.setTabShown(false);
    QMainWindow::hideEvent(event);
}

void SheetTab::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QMainWindow::changeEvent(event);
}

void SheetTab::retranslateUi() {
    panels_.retranslateUi();
    actions_.retranslateUi();
    content_.retranslateUi();
}

Point SheetTab::snapped(Point at) const {
    const std::optional<Snap> snap = isSnapping_ ? canvas_->snapOf({.at = at}) : std::nullopt;
    return snap ? snap->at : at;
}

std::optional<Snap> SheetTab::snapOfDrag(Vector by, Qt::KeyboardModifiers modifiers) {
    const bool isShift = modifiers.testFlag(Qt::ShiftModifier);
    mayShiftSwitch_ = mayShiftSwitch_ || !isShift;
    const std::optional<Point> place = drag_.snappingPlace(by);
    const bool isMoved = by != Vector{}; // back home is home, on the grid or not
    if (!isSnapping_ || !place || !isMoved || (isShift && mayShiftSwitch_))
        return {};
    const bool isLocked = modifiers.testFlag(Qt::ControlModifier);
    const Freedom freedom = !isLocked ? Freedom::both : by.y == 0 ? Freedom::x : Freedom::y;
    return canvas_->snapOf({*place, freedom, drag_.curve(), drag_.moving()});
}

void SheetTab::addPoint(Point at) {
    editor_.addPoint(snapped(at));
}

void SheetTab::addPointOn(GripRef grip, Point at) {
    if (editor_.closeAt(grip))
        canvas_->setTool(Tool::edit);
    else
        editor_.addPoint(snapped(at));
}

void SheetTab::insertPoint(Serial curve, Point at) {
    activateCurve(curve);
    editor_.insertPoint(curve, at);
}

void SheetTab::insertPointBehindSelected() {
    editor_.insertPointBehindSelected();
}

void SheetTab::insertPointHere() {
    if (menuPlace_)
        insertPoint(menuPlace_->curve, menuPlace_->near);
    else
        editor_.insertPointBehindSelected();
}

void SheetTab::beginMenu(const Hit& under, Point at) {
    menuPlace_.reset();
    if (under.grip) {
        if (!editor_.selection().contains(*under.grip))
            select({*under.grip});
        activateCurve(under.grip->serial);
    } else if (under.curve) {
        activateCurve(*under.curve);
        menuPlace_ = CurvePlace{*under.curve, at};
    }
}

void SheetTab::removePoint(GripRef grip) {
    if (grip.id.kind == GripKind::point)
        editor_.removePoints(grip.serial, {grip.id.index}, Removal::refitted);
}

void SheetTab::removeSelected(Removal removal) {
    editor_.removeSelected(removal);
}

void SheetTab::retractHandle(GripRef handle) {
    activateCurve(handle.serial);
    editor_.retractHandle(handle);
}

void SheetTab::select(Selection selection) {
    // Panels show the active curve: choosing points of another curve alone makes that one active.
    const bool isOfOneCurve = !selection.empty() && selection.front().serial == selection.back().serial;
    if (isOfOneCurve)
        editor_.document().setActiveCurve(editor_.index(), selection.front().serial);
    editor_.select(std::move(selection));
}

void SheetTab::activateCurve(Serial curve) {
    editor_.document().setActiveCurve(editor_.index(), curve);
}

void SheetTab::explain(const MarkPlace& mark) {
    panels_.explain(mark);
}

void SheetTab::beginDrag(GripRef grip) {
    activateCurve(grip.serial);
    mayShiftSwitch_ = false;
    drag_.begin(grip);
}

void SheetTab::beginAddDrag(Point at) {
    mayShiftSwitch_ = false;
    drag_.beginAdding(snapped(at));
}

void SheetTab::beginInsertDrag(Serial curve, Point at) {
    activateCurve(curve);
    drag_.beginInserting(curve, at);
}

void SheetTab::beginCurveDrag(Serial curve, Point at) {
    activateCurve(curve);
    drag_.beginOnCurve(curve, at);
}

void SheetTab::drag(Vector by, const DragKeys& keys) {
    const std::optional<Snap> snap = snapOfDrag(by, keys.modifiers);
    canvas_->showSnap(snap);
    drag_.move(by, keys, snap ? std::optional(snap->at) : std::nullopt);
    if (drag_.handle())
        Q_EMIT hintChanged(dragHintText(keys));
}

void SheetTab::endDrag() {
    canvas_->showSnap({});
    drag_.end();
}

void SheetTab::cancelDrag() {
    canvas_->showSnap({});
    drag_.cancel();
}

void SheetTab::hover(const Hit& under, Point at, Qt::KeyboardModifiers modifiers) {
    const Pointing now{under, at, modifiers, canvas_->tool()};
    const bool wouldAdd = isSnapping_ && now.tool == Tool::add && !under.curve;
    canvas_->showSnap(wouldAdd ? canvas_->snapOf({.at = at}) : std::nullopt);
    canvas_->setGhost(ghostFor(editor_, now));
    Q_EMIT hintChanged(hintFor(editor_, now, under.mark && panels_.canExplain(*under.mark)));
}

} // namespace kriva::ui
