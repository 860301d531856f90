#include "ui/sheets/sheet_panels.h"

#include "ui/panels/curves_panel.h"
#include "ui/panels/guide/guide_panel.h"
#include "ui/panels/history_panel.h"
#include "ui/panels/layers_panel.h"
#include "ui/panels/results_panel.h"
#include "ui/sheets/properties_area.h"
#include "ui/shell/export_figure.h"

#include <QCoreApplication>

#include <algorithm>

namespace kriva::ui {
namespace {

constexpr int kPanelWidth = 260; // px, at least: room for a table of points with a column of the sheet's own
constexpr int kGuideWidth = 420; // px: lines of ten words, and pictures that show their labels

} // namespace

SheetPanels::SheetPanels(QMainWindow& tab, SheetEditor& editor, const SheetRelations& relations, const SheetUi& ui)
    : tab_(tab)
    , editor_(editor)
    , relations_(relations)
    , ui_(ui) {}

void SheetPanels::make() {
    if (!panels_.empty())
        return;
    fill();
    firstLayout_ = tab_.saveState();
    tab_.restoreState(layout_);
    retranslateUi();
}

void SheetPanels::fill() {
    add("curves", QT_TRANSLATE_NOOP("SheetPanels", "Curves"), new CurvesPanel(editor_, &tab_), Qt::LeftDockWidgetArea);
    add("points", QT_TRANSLATE_NOOP("SheetPanels", "Points"), new PointsPanel(editor_, ui_.pointColumns, &tab_),
        Qt::LeftDockWidgetArea);
    add("layers", QT_TRANSLATE_NOOP("SheetPanels", "Layers"), new LayersPanel(editor_, &tab_), Qt::LeftDockWidgetArea);
    auto* properties = new PropertiesArea(&tab_);
    properties->setWidget(ui_.makeProperties(editor_, properties));
    add("properties", QT_TRANSLATE_NOOP("SheetPanels", "Properties"), properties, Qt::RightDockWidgetArea);
    add("results", QT_TRANSLATE_NOOP("SheetPanels", "Results"), new ResultsPanel(editor_, relations_, &tab_),
        Qt::RightDockWidgetArea);
    auto* plots = new PlotsPanel(editor_, ui_.plots, &tab_);
    QObject::connect(plots, &PlotsPanel::exportRequested, &tab_,
                     [this](const std::vector<Plot>& shown) { exportPlots(shown, &tab_); });
    add("plots", QT_TRANSLATE_NOOP("SheetPanels", "Plots"), plots, Qt::RightDockWidgetArea);
    add("tables", QT_TRANSLATE_NOOP("SheetPanels", "Tables"), new TablesPanel(editor_, ui_.tables, &tab_),
        Qt::RightDockWidgetArea);
    add("history", QT_TRANSLATE_NOOP("SheetPanels", "History"), new HistoryPanel(editor_, &tab_),
        Qt::RightDockWidgetArea);
    const std::string_view sheet = sheetName(editor_.index());
    guide_ = new GuidePanel(QString::fromUtf8(sheet.data(), static_cast<qsizetype>(sheet.size())), &tab_);
    guide_->setExample(example_);
    add("guide", QT_TRANSLATE_NOOP("SheetPanels", "Guide"), guide_, Qt::RightDockWidgetArea);
    for (const Panel& panel : panels_)
        if (panel.dock->widget() != properties) // they know their own width
            panel.dock->widget()->setMinimumWidth(kPanelWidth);
    // What is looked at now and then waits behind its neighbours.
    tab_.tabifyDockWidget(panels_[0].dock, panels_[2].dock);
    for (std::size_t i = 5; i < panels_.size(); ++i)
        tab_.tabifyDockWidget(panels_[i - 1].dock, panels_[i].dock);
    panels_[0].dock->raise();
    panels_[4].dock->raise();
}

void SheetPanels::add(const char* name, const char* title, QWidget* widget, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(&tab_);
    dock->setObjectName(QString::fromLatin1(name));
    dock->setWidget(widget);
    tab_.addDockWidget(area, dock);
    panels_.push_back({dock, title});
}

QList<QAction*> SheetPanels::actions() {
    make();
    QList<QAction*> actions;
    for (const Panel& panel : panels_)
        actions.append(panel.dock->toggleViewAction());
    return actions;
}

QByteArray SheetPanels::layout() const {
    return panels_.empty() ? layout_ : tab_.saveState();
}

void SheetPanels::setLayout(const QByteArray& layout) {
    layout_ = layout;
    if (!panels_.empty())
        tab_.restoreState(layout);
}

void SheetPanels::reset() {
    setLayout(firstLayout_);
}

void SheetPanels::show(const char* name) {
    make();
    QDockWidget* dock = dockOf(name);
    dock->show();
    dock->raise();
    dock->widget()->setFocus();
}

QDockWidget* SheetPanels::dockOf(const char* name) const {
    return tab_.findChild<QDockWidget*>(QString::fromLatin1(name));
}

void SheetPanels::beginRenaming() {
    show("curves");
    static_cast<CurvesPanel*>(panels_.front().dock->widget())->beginRenaming();
}

void SheetPanels::showGuide() {
    show("guide");
    QDockWidget* dock = dockOf("guide");
    if (dock->isFloating())
        return;
    // Who asks for it wants to read: it takes the room for that where it has less.
    const int width = std::min(kGuideWidth, tab_.width() * 2 / 5);
    const int height = tab_.height() * 2 / 3;
    if (dock->width() < width)
        tab_.resizeDocks({dock}, {width}, Qt::Horizontal);
    if (dock->height() < height)
        tab_.resizeDocks({dockOf("properties"), dock}, {tab_.height() - height, height}, Qt::Vertical);
}

void SheetPanels::setExample(const Example* example) {
    example_ = example;
    if (guide_)
        guide_->setExample(example);
}

void SheetPanels::retranslateUi() {
    for (const Panel& panel : panels_)
        panel.dock->setWindowTitle(QCoreApplication::translate("SheetPanels", panel.title));
}

} // namespace kriva::ui
