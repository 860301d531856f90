#include "ui/sheets/sheet_tab.h"

#include "core/figure/page.h"
#include "ui/panels/curves_panel.h"
#include "ui/panels/history_panel.h"
#include "ui/panels/layers_panel.h"
#include "ui/panels/results_panel.h"
#include "ui/sheets/hint_text.h"
#include "ui/sheets/properties_area.h"

#include <QCoreApplication>
#include <QEvent>

namespace kriva::ui {
namespace {

constexpr double kPixelsPerMillimetre = 96 / 25.4;
constexpr int kPanelWidth = 260; // px, at least: room for a table of points with a column of the sheet's own

} // namespace

SheetTab::SheetTab(OpenDocument& document, SheetIndex sheet, const SheetUi& ui, QWidget* parent)
    : QMainWindow(parent)
    , editor_(document, sheet)
    , canvas_(new CanvasView(*this, this))
    , ui_(ui) {
    setWindowFlags(Qt::Widget); // a main window inside another: for its docks only
    setDockNestingEnabled(true);
    setCentralWidget(canvas_);

    connect(&document, &OpenDocument::replaced, this, [this] {
        showAllCurves();
        followPage();
        canvas_->fitAll();
    });
    connect(&document, &OpenDocument::curvesChanged, this, [this](SheetIndex changed) {
        if (changed == editor_.index())
            showAllCurves();
    });
    connect(&document, &OpenDocument::viewChanged, this, [this](SheetIndex changed) {
        if (changed == editor_.index())
            showAllCurves();
    });
    connect(&editor_, &SheetEditor::shownCurveChanged, this, &SheetTab::updateCurve);
    connect(&editor_, &SheetEditor::hint, this, [this](const Hint& hint) { Q_EMIT told(hint.text()); });
    connect(&editor_, &SheetEditor::selectionChanged, this, [this] { canvas_->setSelection(editor_.selection()); });
    retranslateUi();
}

void SheetTab::setVisible(bool isVisible) {
    if (isVisible)
        makePanels();
    QMainWindow::setVisible(isVisible);
}

void SheetTab::makePanels() {
    if (!panels_.empty())
        return;
    fillPanels();
    firstLayout_ = saveState();
    restoreState(layout_);
    retranslatePanels();
}

void SheetTab::fillPanels() {
    addPanel("curves", QT_TRANSLATE_NOOP("SheetTab", "Curves"), new CurvesPanel(editor_, this), Qt::LeftDockWidgetArea);
    addPanel("points", QT_TRANSLATE_NOOP("SheetTab", "Points"), new PointsPanel(editor_, ui_.pointColumns, this),
             Qt::LeftDockWidgetArea);
    addPanel("layers", QT_TRANSLATE_NOOP("SheetTab", "Layers"), new LayersPanel(editor_, this), Qt::LeftDockWidgetArea);
    auto* properties = new PropertiesArea(this);
    properties->setWidget(ui_.makeProperties(editor_, properties));
    addPanel("properties", QT_TRANSLATE_NOOP("SheetTab", "Properties"), properties, Qt::RightDockWidgetArea);
    addPanel("results", QT_TRANSLATE_NOOP("SheetTab", "Results"), new ResultsPanel(editor_, this),
             Qt::RightDockWidgetArea);
    addPanel("history", QT_TRANSLATE_NOOP("SheetTab", "History"), new HistoryPanel(editor_, this),
             Qt::RightDockWidgetArea);
    for (const Panel& panel : panels_)
        if (panel.dock->widget() != properties) // they know their own width
            panel.dock->widget()->setMinimumWidth(kPanelWidth);
    // Layers and history are looked at now and then: they wait behind their neighbours.
    tabifyDockWidget(panels_[0].dock, panels_[2].dock);
    tabifyDockWidget(panels_[4].dock, panels_[5].dock);
    panels_[0].dock->raise();
    panels_[4].dock->raise();
}

void SheetTab::addPanel(const char* name, const char* title, QWidget* panel, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(this);
    dock->setObjectName(QString::fromLatin1(name));
    dock->setWidget(panel);
    addDockWidget(area, dock);
    panels_.push_back({dock, title, area});
}

QList<QAction*> SheetTab::panelActions() {
    makePanels();
    QList<QAction*> actions;
    for (const Panel& panel : panels_)
        actions.append(panel.dock->toggleViewAction());
    return actions;
}

void SheetTab::resetPanels() {
    setPanelLayout(firstLayout_);
}

QByteArray SheetTab::panelLayout() const {
    return panels_.empty() ? layout_ : saveState();
}

void SheetTab::setPanelLayout(const QByteArray& layout) {
    layout_ = layout;
    if (!panels_.empty())
        restoreState(layout);
}

void SheetTab::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QMainWindow::changeEvent(event);
}

void SheetTab::retranslateUi() {
    retranslatePanels();
    showAllCurves(); // numbers and captions on the canvas follow the language
}

void SheetTab::retranslatePanels() {
    for (const Panel& panel : panels_)
        panel.dock->setWindowTitle(QCoreApplication::translate("SheetTab", panel.title));
}

CanvasCurve SheetTab::canvasCurve(Serial serial) const {
    const Curve& curve = *editor_.shown(serial);
    const SheetIndex sheet = editor_.index();
    const SheetView& view = editor_.sheet().view;
    const bool isActive = serial == editor_.activeSerial();
    CanvasCurve shown;
    shown.serial = serial;
    shown.isActive = isActive;
    if (viewOf(curve).isShown) {
        const int index = *editor_.document().indexOf(sheet, serial);
        const FigureContext context{index, isActive};
        shown.figure = shownLayers(figureOf(curve, context), layersOf(sheet), view, context);
        shown.grips = grips(curve);
    }
    return shown;
}

void SheetTab::followPage() {
    const Box box = boxOf(figureOf(editor_.sheet(), editor_.index()));
    canvas_->setUnitScale(pageOf(box, editor_.sheet().view.mmPerUnit).mmPerUnit * kPixelsPerMillimetre);
}

void SheetTab::showAllCurves() {
    std::vector<CanvasCurve> curves;
    for (const Serial serial : editor_.document().serials(editor_.index()))
        curves.push_back(canvasCurve(serial));
    canvas_->setCurves(std::move(curves));
    canvas_->setSelection(editor_.selection());
}

void SheetTab::updateCurve(Serial serial) {
    canvas_->updateCurve(canvasCurve(serial));
}

void SheetTab::addPoint(Point at) {
    editor_.addPoint(at);
}

void SheetTab::addPointOn(GripRef, Point at) {
    editor_.addPoint(at);
}

void SheetTab::insertPoint(Serial curve, Point at) {
    activateCurve(curve);
    editor_.insertPoint(curve, at);
}

void SheetTab::removePoint(GripRef grip) {
    if (grip.id.kind == GripKind::point)
        editor_.removePoints(grip.serial, {grip.id.index}, Removal::refitted);
}

void SheetTab::removeSelected(Removal removal) {
    editor_.removeSelected(removal);
}

void SheetTab::select(Selection selection) {
    // Panels show the active curve: choosing points of another curve alone makes that one active.
    const bool isOfOneCurve = !selection.empty() && selection.begin()->serial == selection.rbegin()->serial;
    if (isOfOneCurve)
        editor_.document().setActiveCurve(editor_.index(), selection.begin()->serial);
    editor_.select(std::move(selection));
}

void SheetTab::activateCurve(Serial curve) {
    editor_.document().setActiveCurve(editor_.index(), curve);
}

void SheetTab::beginDrag(GripRef grip) {
    activateCurve(grip.serial);
    drag_.begin(grip);
}

void SheetTab::beginAddDrag(Point at) {
    drag_.beginAdding(at);
}

void SheetTab::beginCurveDrag(Serial curve, Point at) {
    activateCurve(curve);
    drag_.beginOnCurve(curve, at);
}

void SheetTab::drag(Vector by, Qt::KeyboardModifiers) {
    drag_.move(by);
}

void SheetTab::endDrag() {
    drag_.end();
}

void SheetTab::cancelDrag() {
    drag_.cancel();
}

void SheetTab::nudge(Vector by) {
    editor_.nudge(by);
}

void SheetTab::hover(const Hit& under, Point, Qt::KeyboardModifiers modifiers) {
    Q_EMIT hintChanged(hintText(under, modifiers, canvas_->tool()));
}

} // namespace kriva::ui
