#include "ui/window/main_window.h"

#include "ui/base/language/plain_text.h"
#include "ui/base/language/qt_texts.h"
#include "ui/base/preferences.h"
#include "ui/window/actions/actions.h"
#include "ui/window/actions/menus.h"
#include "ui/window/actions/physical_shortcuts.h"
#include "ui/window/context_menu.h"
#include "ui/window/dialogs/plain_file_dialogs.h"
#include "ui/window/document_session.h"
#include "ui/window/help.h"
#include "ui/window/notice_bar.h"
#include "ui/window/status_row.h"
#include "ui/window/tab_actions.h"

#include <QCloseEvent>
#include <QCoreApplication>
#include <QShortcut>
#include <QThread>
#include <QVBoxLayout>

#include <algorithm>

namespace kriva::ui {
namespace {

/// Two at least, so that quick results need not wait for slow ones; one core stays with the window where there are
/// more.
int workerCount() {
    return std::max(2, QThread::idealThreadCount() - 1);
}

} // namespace

MainWindow::MainWindow(const Surroundings& surroundings)
    : surroundings_(surroundings)
    , actions_(new Actions(this))
    , session_(new DocumentSession(document_, surroundings.preferences, surroundings.files, this))
    , menus_(new Menus(*menuBar(), *addToolBar(QString()), *actions_))
    , status_(new StatusRow(this))
    , tabWidget_(new QTabWidget(this)) {
    workers_.setMaxThreadCount(workerCount());
    setObjectName(QStringLiteral("mainWindow"));
    if (!restoreGeometry(surroundings_.preferences.windowGeometry())) // the tabs share out what there is
        resize(1280, 800);
    setWindowIcon(applicationIcon());
    tabWidget_->setDocumentMode(true);
    auto* centre = new QWidget(this);
    auto* rows = new QVBoxLayout(centre);
    rows->setContentsMargins({});
    rows->setSpacing(0);
    rows->addWidget(new NoticeBar(*session_, centre));
    rows->addWidget(tabWidget_, 1);
    setCentralWidget(centre);
    setStatusBar(status_);
    makeTabs(surroundings.sheets);
    connectActions();
    connectEditActions();
    connectViewActions();
    const auto* tabActions = new TabActions(*this, *actions_, *menus_, surroundings_.preferences);
    connect(tabActions, &TabActions::told, status_, &StatusRow::tell);
    const auto* help = new Help(*this, *actions_);
    connect(help, &Help::told, status_, &StatusRow::tell);
    menus_->setRecentFiles(surroundings_.preferences.recentFiles());
    menus_->setLanguage(surroundings_.language.language());
    menus_->setThemeChoice(surroundings_.theme.theme());
    new PhysicalShortcuts(*this);
    new PlainFileDialogs(this);
    followTab();
    showTheme();
    retranslateUi();
}

MainWindow::~MainWindow() {
    // The tabs look at the document as long as they live, and they would outlive it: it is a member, they are children.
    tabWidget_->disconnect(this);
    document_.disconnect(this);
    document_.histories().disconnect(this);
    delete tabWidget_;
}

void MainWindow::makeTabs(std::span<const SheetUi> sheets) {
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        auto* tab = new SheetTab(document_, workers_, sheet, sheets[sheet], this);
        tab->panels().layout().restore(surroundings_.preferences.panelLayout(QString::fromUtf8(sheetName(sheet))));
        tabs_.push_back(tab);
        tabWidget_->addTab(tab, QString());
        auto* shortcut = new QShortcut(QKeySequence(Qt::ALT | static_cast<Qt::Key>(Qt::Key_1 + sheet)), this);
        connect(shortcut, &QShortcut::activated, this, [this, sheet] { document_.setActiveSheet(sheet); });
        connect(&tab->input(), &SheetInput::hintChanged, status_, &StatusRow::showHint);
        connect(&tab->input(), &SheetInput::menuRequested, this,
                [this, tab](QPoint at, const Hit& under) { openContextMenu(*tab, *actions_, at, under); });
        connect(&tab->editor(), &SheetEditor::hint, status_, [this](const Hint& hint) { status_->tell(hint.text()); });
        connect(&tab->canvas(), &CanvasView::pointerMoved, status_, &StatusRow::showPointer);
        connect(&tab->canvas(), &CanvasView::pointerLeft, status_, &StatusRow::forgetPointer);
        connect(&tab->canvas(), &CanvasView::zoomChanged, this, [this, tab](double percent) {
            if (tab == &currentTab())
                status_->showZoom(percent);
        });
        connect(&tab->canvas(), &CanvasView::toolChanged, this, &MainWindow::followTab);
        connect(&tab->canvas().scene(), &CanvasScene::gridShownChanged, actions_->grid, &QAction::setChecked);
        connect(&tab->editor(), &SheetEditor::selectionChanged, this, &MainWindow::followSelection);
    }
    connect(tabWidget_, &QTabWidget::currentChanged, this,
            [this](int index) { document_.setActiveSheet(static_cast<SheetIndex>(index)); });
    connect(&document_.histories(), &QUndoGroup::indexChanged, status_, &StatusRow::endTelling);
    connect(&document_, &OpenDocument::activeSheetChanged, this, &MainWindow::followTab);
    connect(&document_, &OpenDocument::replaced, this, &MainWindow::followTab);
    connect(&document_, &OpenDocument::curvesChanged, this, &MainWindow::followSelection);
    connect(&document_, &OpenDocument::viewChanged, this, &MainWindow::followSelection);
}

void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QMainWindow::changeEvent(event);
}

void MainWindow::retranslateUi() {
    tabWidget_->setAccessibleName(tr("Sheets"));
    for (SheetIndex sheet = 0; sheet < tabs_.size(); ++sheet)
        tabWidget_->setTabText(static_cast<int>(sheet), sheetTitle(sheet));
    actions_->retranslateUi();
    menus_->retranslateUi();
    renameQtButtons(*this);
    showTitle();
    followHistory();
}

void MainWindow::showTitle() {
    setWindowTitle(QStringLiteral("%1[*] – Kriva").arg(windowTitleOf(session_->name())));
}

QString MainWindow::sheetTitle(SheetIndex sheet) const {
    return QCoreApplication::translate("Sheet", surroundings_.sheets[sheet].title);
}

void MainWindow::followTab() {
    const SheetIndex sheet = document_.value().active;
    tabWidget_->setCurrentIndex(static_cast<int>(sheet));
    menus_->setSheetActions(tabs_[sheet]->actions().all());
    menus_->setPanels(tabs_[sheet]->panels().actions());
    if (isVisible())
        tabs_[sheet]->panels().layOut();
    CanvasView& canvas = tabs_[sheet]->canvas();
    actions_->editTool->setChecked(canvas.tool() == Tool::edit);
    actions_->addTool->setChecked(canvas.tool() == Tool::add);
    actions_->grid->setChecked(canvas.scene().isGridShown());
    actions_->axes->setChecked(canvas.scene().areAxesShown());
    status_->showZoom(canvas.zoomPercent());
    followSelection();
    followHistory();
}

void MainWindow::followHistory() {
    const QUndoGroup& histories = document_.histories();
    actions_->undo->setEnabled(histories.canUndo());
    actions_->redo->setEnabled(histories.canRedo());
    actions_->undo->setText(histories.canUndo() ? tr("&Undo: %1").arg(resolvedStep(histories.undoText()))
                                                : tr("&Undo"));
    actions_->redo->setText(histories.canRedo() ? tr("&Redo: %1").arg(resolvedStep(histories.redoText()))
                                                : tr("&Redo"));
}

void MainWindow::followSelection() {
    actions_->deleteSelected->setEnabled(currentTab().editor().hasSelectedPoints());
}

void MainWindow::showTheme() {
    for (SheetTab* tab : tabs_)
        tab->canvas().scene().setTheme(surroundings_.theme.isDark() ? Theme::dark : Theme::light);
}

void MainWindow::setVisible(bool isVisible) {
    QMainWindow::setVisible(isVisible);
    // A tab that is shown together with its window has its size only now. Panels that float come behind the window:
    // else some window managers do not know yet what they belong to, and leave them under it.
    if (isVisible)
        currentTab().panels().layOut();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!session_->mayClose()) {
        event->ignore();
        return;
    }
    surroundings_.preferences.setWindowGeometry(saveGeometry());
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        surroundings_.preferences.setPanelLayout(QString::fromUtf8(sheetName(sheet)),
                                                 tabs_[sheet]->panels().layout().state());
    event->accept();
}

} // namespace kriva::ui
