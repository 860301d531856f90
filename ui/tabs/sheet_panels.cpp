#include "ui/tabs/sheet_panels.h"

#include "ui/export/figure_export.h"
#include "ui/panels/curves_panel.h"
#include "ui/panels/guide/guide_panel.h"
#include "ui/panels/history_panel.h"
#include "ui/panels/layers_panel.h"
#include "ui/panels/plots/plots_panel.h"
#include "ui/panels/results_panel.h"
#include "ui/panels/watched_panel.h"
#include "ui/tabs/properties/properties_area.h"

#include <QCoreApplication>

#include <algorithm>

namespace kriva::ui {
namespace {

constexpr int kColumnWidth = 260; // px: room for a table of points with a column of the sheet's own
constexpr int kRightWidth = 360;  // px: plots with room for their legends
// px, in a window of usual size: most properties are seen at once.
constexpr int kPropertiesHeight = 380;
constexpr int kResultsHeight = 320;
constexpr int kGuideWidth = 420; // px: lines of ten words, and pictures that show their labels

} // namespace

SheetPanels::SheetPanels(QMainWindow& tab, SheetEditor& editor, const SheetRelations& relations, const SheetUi& ui)
    : tab_(tab)
    , editor_(editor)
    , relations_(relations)
    , ui_(ui) {}

SheetPanels::~SheetPanels() {
    // They look at the editor to their end: a cell of a panel that floats loses the focus then.
    for (const Panel& panel : panels_)
        delete panel.dock;
}

void SheetPanels::make() {
    if (!panels_.empty())
        return;
    fill();
    retranslateUi();
}

void SheetPanels::layOut() {
    if (layout_.hasBegun())
        return;
    // Not as wide as their titles want to be, which differs from language to language.
    tab_.resizeDocks({dockOf("curves"), dockOf("properties")}, {kColumnWidth, kRightWidth}, Qt::Horizontal);
    tab_.resizeDocks({dockOf("properties"), dockOf("results")}, {kPropertiesHeight, kResultsHeight}, Qt::Vertical);
    layout_.begin();
}

void SheetPanels::fill() {
    add(Qt::LeftDockWidgetArea,
        {{"curves", QT_TRANSLATE_NOOP("SheetPanels", "Curves"), [this] { return new CurvesPanel(editor_); }},
         {"layers", QT_TRANSLATE_NOOP("SheetPanels", "Layers"), [this] { return new LayersPanel(editor_); }}});
    add(Qt::LeftDockWidgetArea,
        {{"points", QT_TRANSLATE_NOOP("SheetPanels", "Points"),
          [this] { return new PointsPanel(editor_, ui_.pointColumns); }},
         {"history", QT_TRANSLATE_NOOP("SheetPanels", "History"), [this] { return new HistoryPanel(editor_); }}});
    add(Qt::RightDockWidgetArea,
        {{"properties", QT_TRANSLATE_NOOP("SheetPanels", "Properties"), [this] { return properties(); }}});
    add(Qt::RightDockWidgetArea, {{"results", QT_TRANSLATE_NOOP("SheetPanels", "Results"),
                                   [this] { return new ResultsPanel(editor_, relations_); }},
                                  {"plots", QT_TRANSLATE_NOOP("SheetPanels", "Plots"), [this] { return plots(); }},
                                  {"tables", QT_TRANSLATE_NOOP("SheetPanels", "Tables"),
                                   [this] { return new TablesPanel(editor_, ui_.tables); }},
                                  {"guide", QT_TRANSLATE_NOOP("SheetPanels", "Guide"), [this] { return guide(); }}});
}

void SheetPanels::add(Qt::DockWidgetArea area, std::initializer_list<NewPanel> group) {
    QDockWidget* front = nullptr;
    for (const NewPanel& panel : group) {
        auto* dock = new QDockWidget(&tab_);
        dock->setObjectName(QString::fromLatin1(panel.name));
        if (front)
            tab_.tabifyDockWidget(panels_.back().dock, dock);
        else
            tab_.addDockWidget(area, dock);
        front = front ? front : dock;
        panels_.push_back({dock, panel.title});
        layout_.add(dock);
        QObject::connect(dock, &QDockWidget::topLevelChanged, dock,
                         [entry = panels_.back(), title = ui_.title] { retitle(entry, title); });
        QObject::connect(dock, &QDockWidget::visibilityChanged, dock, [dock, make = panel.make](bool isVisible) {
            if (isVisible && !dock->widget()) {
                dock->setWidget(make());
                if (!qobject_cast<PropertiesArea*>(dock->widget())) // it knows its own
                    dock->widget()->setMinimumWidth(kColumnWidth);
            }
            if (auto* watched = dynamic_cast<WatchedPanel*>(dock->widget()))
                watched->setWatched(isVisible);
        });
    }
    front->raise();
}

QWidget* SheetPanels::properties() const {
    auto* area = new PropertiesArea;
    area->setWidget(ui_.makeProperties(editor_, area));
    return area;
}

QWidget* SheetPanels::plots() {
    auto* panel = new PlotsPanel(editor_);
    QObject::connect(panel, &PlotsPanel::exportRequested, &tab_, [this](const std::vector<Plot>& shown) {
        exportPlots(shown, exportedPlots_, editor_.workers(), &tab_);
    });
    return panel;
}

QWidget* SheetPanels::guide() {
    guide_ = new GuidePanel(QString::fromUtf8(sheetName(editor_.index())));
    guide_->setExample(example_);
    return guide_;
}

QList<QAction*> SheetPanels::actions() {
    make();
    QList<QAction*> actions;
    for (const Panel& panel : panels_)
        actions.append(panel.dock->toggleViewAction());
    return actions;
}

void SheetPanels::show(const char* name) {
    bringToFront(name)->widget()->setFocus();
}

QDockWidget* SheetPanels::bringToFront(const char* name) {
    make();
    QDockWidget* dock = dockOf(name);
    dock->show();
    dock->raise();
    return dock;
}

QDockWidget* SheetPanels::dockOf(const char* name) const {
    return tab_.findChild<QDockWidget*>(QString::fromLatin1(name));
}

void SheetPanels::explain(Point mark) {
    static_cast<TablesPanel*>(bringToFront("tables")->widget())->explain(mark);
}

void SheetPanels::beginRenaming() {
    show("curves");
    static_cast<CurvesPanel*>(dockOf("curves")->widget())->beginRenaming();
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
        retitle(panel, ui_.title);
}

/// A window of its own says to which tab it belongs.
void SheetPanels::retitle(const Panel& panel, const char* sheetTitle) {
    const QString title = QCoreApplication::translate("SheetPanels", panel.title);
    panel.dock->setWindowTitle(panel.dock->isFloating() ? QStringLiteral("%1 – %2").arg(
                                                              title, QCoreApplication::translate("Sheet", sheetTitle))
                                                        : title);
    panel.dock->toggleViewAction()->setText(title); // in a menu that is the tab's already
}

} // namespace kriva::ui
