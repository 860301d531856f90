#include "ui/base/preferences.h"
#include "ui/document/error_text.h"
#include "ui/window/actions/actions.h"
#include "ui/window/actions/menus.h"
#include "ui/window/document_session.h"
#include "ui/window/main_window.h"
#include "ui/window/status_row.h"

namespace kriva::ui {

void MainWindow::connectActions() {
    connect(actions_->newDocument, &QAction::triggered, session_, &DocumentSession::newDocument);
    connect(actions_->newWindow, &QAction::triggered, this, &MainWindow::newWindowAsked);
    connect(actions_->open, &QAction::triggered, session_, &DocumentSession::open);
    connect(actions_->save, &QAction::triggered, session_, &DocumentSession::save);
    connect(actions_->saveAs, &QAction::triggered, session_, &DocumentSession::saveAs);
    connect(actions_->quit, &QAction::triggered, this, &QWidget::close);
    connect(menus_, &Menus::recentFileChosen, session_, &DocumentSession::openInstead);
    connect(session_, &DocumentSession::told, status_, &StatusRow::tell);
    connect(menus_, &Menus::exampleChosen, session_, &DocumentSession::openExample);
    connect(menus_, &Menus::languageChosen, this, [this](Language language) {
        surroundings_.preferences.setLanguage(language);
        surroundings_.language.setLanguage(language);
    });
    connect(&surroundings_.language, &LanguageSwitch::changed, this,
            [this] { menus_->setLanguage(surroundings_.language.language()); });
    connect(menus_, &Menus::themeChosen, this, [this](ThemeChoice choice) {
        surroundings_.preferences.setTheme(choice);
        surroundings_.theme.setTheme(choice);
    });
    connect(&surroundings_.theme, &ThemeSwitch::changed, this, &MainWindow::showTheme);
    connect(session_, &DocumentSession::pathChanged, this, [this] {
        showTitle();
        menus_->setRecentFiles(surroundings_.preferences.recentFiles());
    });
    connect(session_, &DocumentSession::unsavedChanged, this, [this] { setWindowModified(session_->isUnsaved()); });
    connect(&document_, &OpenDocument::refused, this,
            [this](const FileError& error) { status_->tell(errorText(error)); });
}

void MainWindow::connectEditActions() {
    const auto onEditor = [this](QAction* action, void (SheetEditor::*edit)()) {
        connect(action, &QAction::triggered, this, [this, edit] { (currentTab().editor().*edit)(); });
    };
    const auto onActiveCurve = [this](QAction* action, void (SheetEditor::*edit)(Serial)) {
        connect(action, &QAction::triggered, this, [this, edit] {
            SheetEditor& editor = currentTab().editor();
            (editor.*edit)(editor.activeSerial());
        });
    };
    connect(actions_->undo, &QAction::triggered, &document_, &OpenDocument::undo);
    connect(actions_->redo, &QAction::triggered, &document_, &OpenDocument::redo);
    connect(actions_->deleteSelected, &QAction::triggered, this,
            [this] { currentTab().editor().removeSelected(Removal::refitted); });
    onEditor(actions_->deleteLastPoint, &SheetEditor::removeLastPoint);
    onEditor(actions_->clearCanvas, &SheetEditor::beginAnew);
    onEditor(actions_->selectAll, &SheetEditor::selectAll);
    onEditor(actions_->selectNone, &SheetEditor::selectNone);
    onEditor(actions_->selectInverse, &SheetEditor::invertSelection);
    connect(actions_->insertPoint, &QAction::triggered, this, [this] { currentTab().input().insertPointHere(); });
    onEditor(actions_->newCurve, &SheetEditor::beginCurve);
    onEditor(actions_->nextCurve, &SheetEditor::activateNextCurve);
    onEditor(actions_->reverseCurve, &SheetEditor::reverse);
    onActiveCurve(actions_->duplicateCurve, &SheetEditor::duplicateCurve);
    onActiveCurve(actions_->deleteCurve, &SheetEditor::deleteCurve);
    connect(&document_.histories(), &QUndoGroup::indexChanged, this, &MainWindow::followHistory);
    connect(&document_.histories(), &QUndoGroup::activeStackChanged, this, &MainWindow::followHistory);
}

void MainWindow::connectViewActions() {
    const auto onCanvas = [this](QAction* action, void (CanvasView::*act)()) {
        connect(action, &QAction::triggered, this, [this, act] { (currentTab().canvas().*act)(); });
    };
    onCanvas(actions_->zoomIn, &CanvasView::zoomIn);
    onCanvas(actions_->zoomOut, &CanvasView::zoomOut);
    onCanvas(actions_->zoomTo100, &CanvasView::zoomTo100);
    onCanvas(actions_->fitAll, &CanvasView::fitAll);
    onCanvas(actions_->fitSelection, &CanvasView::fitSelection);
    connect(actions_->editTool, &QAction::triggered, this, [this] { currentTab().canvas().setTool(Tool::edit); });
    connect(actions_->addTool, &QAction::triggered, this, [this] { currentTab().canvas().setTool(Tool::add); });
    connect(actions_->grid, &QAction::triggered, this,
            [this](bool on) { currentTab().canvas().scene().setGridShown(on); });
    connect(actions_->axes, &QAction::triggered, this,
            [this](bool on) { currentTab().canvas().scene().setAxesShown(on); });
    connect(actions_->resetPanels, &QAction::triggered, this, [this] { currentTab().panels().layout().reset(); });
    connect(actions_->showHistory, &QAction::triggered, this, [this] { currentTab().panels().show("history"); });
    connect(actions_->fullScreen, &QAction::triggered, this, [this](bool on) { on ? showFullScreen() : showNormal(); });
}

} // namespace kriva::ui
