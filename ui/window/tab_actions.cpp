#include "ui/window/tab_actions.h"

#include "ui/base/preferences.h"
#include "ui/controls/typing.h"
#include "ui/editing/clipboard_edits.h"
#include "ui/window/actions/actions.h"
#include "ui/window/actions/menus.h"
#include "ui/window/document_session.h"
#include "ui/window/main_window.h"
#include "ui/window/points_import.h"

#include <QEvent>

namespace kriva::ui {

TabActions::TabActions(MainWindow& window, const Actions& actions, Menus& menus, Preferences& preferences)
    : QObject(&window)
    , window_(window)
    , actions_(actions)
    , menus_(menus)
    , preferences_(preferences)
    , export_(&window) {
    connectOutlets();
    connectCurve();
    connectCanvas();
    OpenDocument& document = window.document();
    connect(&document, &OpenDocument::activeSheetChanged, this, &TabActions::follow);
    connect(&document, &OpenDocument::replaced, this, &TabActions::follow);
    connect(&document, &OpenDocument::curvesChanged, this, &TabActions::followCurve);
    connect(&document, &OpenDocument::viewChanged, this, &TabActions::followCurve);
    connect(&document, &OpenDocument::curveChanged, this, &TabActions::followCurve);
    follow();
}

bool TabActions::event(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        follow(); // the names of the other tabs
    return QObject::event(event);
}

SheetEditor& TabActions::editor() const {
    return window_.currentTab().editor();
}

void TabActions::connectOutlets() {
    const auto endEdits = [this] {
        commitTyping(window_);
        window_.document().endGesture();
    };
    connect(actions_.importPoints, &QAction::triggered, this, [this] {
        if (importPoints(editor(), &window_))
            window_.currentTab().canvas().fitAll();
    });
    connect(actions_.exportFigure, &QAction::triggered, this, [this, endEdits] {
        endEdits();
        export_.ask(editor(), window_.session().name());
    });
    connect(actions_.exportAgain, &QAction::triggered, this, [this, endEdits] {
        endEdits();
        export_.again(editor(), window_.session().name());
    });
    connect(actions_.copyFigure, &QAction::triggered, this, [this] { export_.copy(editor()); });
    connect(actions_.copyTikz, &QAction::triggered, this, [this] { export_.copyTikz(editor()); });
    connect(actions_.copyPath, &QAction::triggered, this, [this] { export_.copyPath(editor()); });
    connect(actions_.print, &QAction::triggered, this, [this, endEdits] {
        endEdits();
        export_.print(editor(), window_.session().name());
    });
    connect(&export_, &FigureExport::told, this, &TabActions::told);
    connect(&window_.document(), &OpenDocument::replaced, &export_, &FigureExport::forgetFiles);
    connect(actions_.cut, &QAction::triggered, this, [this] { cutToClipboard(editor()); });
    connect(actions_.copy, &QAction::triggered, this, [this] { copyToClipboard(editor()); });
    connect(actions_.duplicate, &QAction::triggered, this, [this] { duplicateSelected(editor()); });
    connect(actions_.paste, &QAction::triggered, this, [this] {
        if (const QString refusal = pasteFromClipboard(editor()); !refusal.isEmpty())
            Q_EMIT told(refusal);
    });
}

void TabActions::connectCurve() {
    const auto move = [this](int by) {
        editor().moveCurve(editor().activeSerial(), editor().sheet().view.activeCurve + by);
    };
    connect(actions_.renameCurve, &QAction::triggered, this, [this] { window_.currentTab().panels().beginRenaming(); });
    connect(actions_.moveCurveUp, &QAction::triggered, this, [move] { move(-1); });
    connect(actions_.moveCurveDown, &QAction::triggered, this, [move] { move(1); });
    connect(actions_.showCurve, &QAction::triggered, this, [this](bool on) { editor().setActiveCurveShown(on); });
    connect(&menus_, &Menus::otherSheetChosen, this, [this](SheetIndex sheet) { editor().usePointsIn(sheet); });
}

void TabActions::connectCanvas() {
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        window_.tab(sheet).canvas().addAction(actions_.snap);
    connect(actions_.snap, &QAction::toggled, this, &TabActions::setSnapping);
    connect(actions_.rulers, &QAction::toggled, this, &TabActions::setRulersShown);
    actions_.snap->setChecked(preferences_.isSnapping());
    actions_.rulers->setChecked(preferences_.areRulersShown());
}

void TabActions::setSnapping(bool isSnapping) {
    preferences_.setSnapping(isSnapping);
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        window_.tab(sheet).input().setSnapping(isSnapping);
}

void TabActions::setRulersShown(bool areShown) {
    preferences_.setRulersShown(areShown);
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        window_.tab(sheet).ruledCanvas().setRulersShown(areShown);
}

void TabActions::follow() {
    std::vector<std::pair<SheetIndex, QString>> others;
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        if (sheet != window_.document().value().active)
            others.emplace_back(sheet, window_.sheetTitle(sheet));
    menus_.setOtherSheets(others);
    followCurve();
}

void TabActions::followCurve() {
    const Sheet& sheet = editor().sheet();
    const Curve* curve = editor().activeCurve();
    for (QAction* action :
         {actions_.cut, actions_.copy, actions_.duplicate, actions_.copyPath, actions_.renameCurve, actions_.showCurve})
        action->setEnabled(curve != nullptr);
    menus_.setHasCurve(curve != nullptr);
    actions_.moveCurveUp->setEnabled(curve && sheet.view.activeCurve > 0);
    actions_.moveCurveDown->setEnabled(curve && sheet.view.activeCurve + 1 < static_cast<int>(sheet.curves.size()));
    actions_.showCurve->setChecked(curve && viewOf(*curve).isShown);
}

} // namespace kriva::ui
