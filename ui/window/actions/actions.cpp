#include "ui/window/actions/actions.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QWidget>

namespace kriva::ui {

Actions::Actions(QWidget* window)
    : QObject(window)
    , window_(window) {
    makeFile();
    makeEdit();
    makeCurve();
    makeView();
    makeHelp();
    retranslateUi();
}

void Actions::makeFile() {
    newDocument = make("new", QT_TRANSLATE_NOOP("Actions", "&New"), QKeySequence::New, IconName::New);
    newWindow =
        make("newWindow", QT_TRANSLATE_NOOP("Actions", "New &window"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N));
    open = make("open", QT_TRANSLATE_NOOP("Actions", "&Open…"), QKeySequence::Open, IconName::Open);
    save = make("save", QT_TRANSLATE_NOOP("Actions", "&Save"), QKeySequence::Save, IconName::Save);
    saveAs = make("saveAs", QT_TRANSLATE_NOOP("Actions", "Save &as…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S));
    importPoints = make("importPoints", QT_TRANSLATE_NOOP("Actions", "&Import points…"),
                        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I));
    exportFigure = make("exportFigure", QT_TRANSLATE_NOOP("Actions", "&Export figure…"),
                        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E), IconName::Export);
    exportAgain =
        make("exportAgain", QT_TRANSLATE_NOOP("Actions", "Export a&gain"), QKeySequence(Qt::CTRL | Qt::Key_E));
    copyFigure = make("copyFigure", QT_TRANSLATE_NOOP("Actions", "Copy &figure"),
                      QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C));
    copyTikz = make("copyTikz", QT_TRANSLATE_NOOP("Actions", "Copy as &TikZ"));
    copyPath = make("copyPath", QT_TRANSLATE_NOOP("Actions", "Copy pat&h"));
    print = make("print", QT_TRANSLATE_NOOP("Actions", "&Print…"), QKeySequence::Print);
    quit = make("quit", QT_TRANSLATE_NOOP("Actions", "&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q));
    quit->setMenuRole(QAction::QuitRole);
}

void Actions::makeEdit() {
    undo = make("undo", QT_TRANSLATE_NOOP("Actions", "&Undo"), QKeySequence::Undo, IconName::Undo);
    redo = make("redo", QT_TRANSLATE_NOOP("Actions", "&Redo"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z),
                IconName::Redo);
    redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    cut = make("cut", QT_TRANSLATE_NOOP("Actions", "Cu&t"), QKeySequence(Qt::CTRL | Qt::Key_X));
    copy = make("copy", QT_TRANSLATE_NOOP("Actions", "Co&py"), QKeySequence::Copy);
    paste = make("paste", QT_TRANSLATE_NOOP("Actions", "Pa&ste"), QKeySequence::Paste);
    duplicate = make("duplicate", QT_TRANSLATE_NOOP("Actions", "Duplicat&e"), QKeySequence(Qt::CTRL | Qt::Key_D));
    deleteSelected = make("deleteSelected", QT_TRANSLATE_NOOP("Actions", "&Delete"), {}, IconName::Delete);
    deleteLastPoint = make("deleteLastPoint", QT_TRANSLATE_NOOP("Actions", "Delete &last point"));
    clearCanvas = make("clearCanvas", QT_TRANSLATE_NOOP("Actions", "&Clear the canvas"));
    selectAll = make("selectAll", QT_TRANSLATE_NOOP("Actions", "Select &all"), QKeySequence::SelectAll);
    selectNone = make("selectNone", QT_TRANSLATE_NOOP("Actions", "Select n&one"),
                      QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A));
    selectInverse = make("selectInverse", QT_TRANSLATE_NOOP("Actions", "&Invert the selection"),
                         QKeySequence(Qt::CTRL | Qt::Key_I));
}

void Actions::makeCurve() {
    newCurve = make("newCurve", QT_TRANSLATE_NOOP("Actions", "&New curve"), {}, IconName::AddPoint);
    duplicateCurve =
        make("duplicateCurve", QT_TRANSLATE_NOOP("Actions", "&Duplicate the curve"), {}, IconName::Duplicate);
    deleteCurve = make("deleteCurve", QT_TRANSLATE_NOOP("Actions", "De&lete the curve"));
    nextCurve = make("nextCurve", QT_TRANSLATE_NOOP("Actions", "Ne&xt curve"));
    reverseCurve = make("reverseCurve", QT_TRANSLATE_NOOP("Actions", "&Reverse"));
    insertPoint = make("insertPoint", QT_TRANSLATE_NOOP("Actions", "&Insert a point"), QKeySequence(Qt::Key_Insert));
    insertPoint->setShortcutContext(Qt::WidgetShortcut); // the canvas takes the key itself
    renameCurve = make("renameCurve", QT_TRANSLATE_NOOP("Actions", "Rena&me"), QKeySequence(Qt::Key_F2));
    moveCurveUp = make("moveCurveUp", QT_TRANSLATE_NOOP("Actions", "Move &up in the list"), {}, IconName::Up);
    moveCurveDown = make("moveCurveDown", QT_TRANSLATE_NOOP("Actions", "Move do&wn in the list"), {}, IconName::Down);
    showCurve = makeToggle("showCurve", QT_TRANSLATE_NOOP("Actions", "&Show the curve"));
}

void Actions::makeView() {
    editTool = makeToggle("editTool", QT_TRANSLATE_NOOP("Actions", "&Edit tool"), {}, IconName::Edit);
    addTool = makeToggle("addTool", QT_TRANSLATE_NOOP("Actions", "&Add tool"), {}, IconName::AddPoint);
    auto* tools = new QActionGroup(this);
    tools->addAction(editTool);
    tools->addAction(addTool);
    zoomIn = make("zoomIn", QT_TRANSLATE_NOOP("Actions", "Zoom &in"), QKeySequence::ZoomIn, IconName::ZoomIn);
    zoomOut = make("zoomOut", QT_TRANSLATE_NOOP("Actions", "Zoom &out"), QKeySequence::ZoomOut, IconName::ZoomOut);
    zoomTo100 = make("zoomTo100", QT_TRANSLATE_NOOP("Actions", "Zoom to &100 %"), QKeySequence(Qt::CTRL | Qt::Key_1));
    fitAll =
        make("fitAll", QT_TRANSLATE_NOOP("Actions", "&Fit all"), QKeySequence(Qt::CTRL | Qt::Key_0), IconName::Fit);
    fitSelection = make("fitSelection", QT_TRANSLATE_NOOP("Actions", "Fit &selection"));
    grid = makeToggle("grid", QT_TRANSLATE_NOOP("Actions", "&Grid"), {}, IconName::Grid);
    axes = makeToggle("axes", QT_TRANSLATE_NOOP("Actions", "A&xes"));
    rulers = makeToggle("rulers", QT_TRANSLATE_NOOP("Actions", "Ru&lers"), QKeySequence(Qt::CTRL | Qt::Key_R));
    snap = makeToggle("snap", QT_TRANSLATE_NOOP("Actions", "S&nap"), QKeySequence(Qt::Key_N));
    snap->setShortcutContext(Qt::WidgetShortcut); // a letter: of the canvases alone, which know it by its place
    resetPanels = make("resetPanels", QT_TRANSLATE_NOOP("Actions", "&Reset panels"));
    showHistory = make("showHistory", QT_TRANSLATE_NOOP("Actions", "S&how the history"),
                       QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_H));
    fullScreen = makeToggle("fullScreen", QT_TRANSLATE_NOOP("Actions", "F&ull screen"), QKeySequence(Qt::Key_F11));
}

void Actions::makeHelp() {
    guide = make("guide", QT_TRANSLATE_NOOP("Actions", "User &guide"), QKeySequence(Qt::Key_F1));
    shortcuts = make("shortcuts", QT_TRANSLATE_NOOP("Actions", "&Shortcuts"));
    about = make("about", QT_TRANSLATE_NOOP("Actions", "&About Kriva"));
    about->setMenuRole(QAction::AboutRole);
    aboutQt = make("aboutQt", QT_TRANSLATE_NOOP("Actions", "About &Qt"));
    aboutQt->setMenuRole(QAction::AboutQtRole);
}

QAction* Actions::make(const char* name, const char* text, const QKeySequence& shortcut,
                       std::optional<IconName> iconName) {
    auto* action = new QAction(window_);
    action->setObjectName(QString::fromLatin1(name));
    if (!shortcut.isEmpty())
        action->setShortcut(shortcut);
    window_->addAction(action); // its shortcut works while the menu bar is hidden too
    if (iconName)
        action->setIcon(icon(*iconName));
    entries_.push_back({action, text});
    return action;
}

QAction* Actions::makeToggle(const char* name, const char* text, const QKeySequence& shortcut,
                             std::optional<IconName> iconName) {
    QAction* action = make(name, text, shortcut, iconName);
    action->setCheckable(true);
    return action;
}

void Actions::retranslateUi() {
    for (const Entry& entry : entries_)
        entry.action->setText(QCoreApplication::translate("Actions", entry.text));
}

} // namespace kriva::ui
