#include "ui/window/actions/menus.h"

#include "ui/base/examples.h"
#include "ui/base/language/plain_text.h"
#include "ui/window/actions/actions.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QFileInfo>

namespace kriva::ui {
namespace {

constexpr int kNameWidth = 400; // px: of most names all is seen, and the menu stays on the screen

} // namespace

Menus::Menus(QMenuBar& bar, QToolBar& tools, const Actions& actions)
    : QObject(&bar)
    , bar_(bar)
    , tools_(tools) {
    fillFile(actions);
    fillEdit(actions);
    fillCurve(actions);
    fillView(actions);
    fillSettings();
    fillHelp(actions);
    tools.addActions({actions.newDocument, actions.open, actions.save, actions.exportFigure});
    tools.addSeparator();
    tools.addActions({actions.undo, actions.redo});
    tools.addSeparator();
    tools.addActions({actions.editTool, actions.addTool});
    tools.addSeparator();
    tools.addActions({actions.zoomOut, actions.fitAll, actions.zoomIn, actions.grid});
    retranslateUi();
}

QMenu* Menus::add(QMenu* parent, const char* text) {
    QMenu* menu = parent ? parent->addMenu(QString()) : bar_.addMenu(QString());
    titles_.push_back({menu, text});
    return menu;
}

void Menus::fillFile(const Actions& actions) {
    QMenu* file = add(nullptr, QT_TRANSLATE_NOOP("Menus", "&File"));
    file->addActions({actions.newDocument, actions.newWindow, actions.open});
    recent_ = add(file, QT_TRANSLATE_NOOP("Menus", "Open &recent"));
    fillExamples(file);
    file->addSeparator();
    file->addActions({actions.save, actions.saveAs});
    file->addSeparator();
    file->addActions({actions.importPoints, actions.exportFigure, actions.exportAgain, actions.copyFigure,
                      actions.copyTikz, actions.copyPath});
    file->addSeparator();
    file->addAction(actions.print);
    file->addSeparator();
    file->addAction(actions.quit);
}

void Menus::fillEdit(const Actions& actions) {
    QMenu* edit = add(nullptr, QT_TRANSLATE_NOOP("Menus", "&Edit"));
    edit->addActions({actions.undo, actions.redo});
    edit->addSeparator();
    edit->addActions({actions.cut, actions.copy, actions.paste, actions.duplicate});
    edit->addSeparator();
    edit->addActions({actions.deleteSelected, actions.deleteLastPoint, actions.clearCanvas});
    edit->addSeparator();
    edit->addActions({actions.selectAll, actions.selectNone, actions.selectInverse});
}

void Menus::fillCurve(const Actions& actions) {
    curve_ = add(nullptr, QT_TRANSLATE_NOOP("Menus", "&Curve"));
    curve_->addActions({actions.newCurve, actions.nextCurve, actions.duplicateCurve, actions.deleteCurve,
                        actions.reverseCurve, actions.insertPoint});
    curve_->addSeparator();
    curve_->addActions({actions.renameCurve, actions.showCurve, actions.moveCurveUp, actions.moveCurveDown});
    curve_->addSeparator();
    otherSheets_ = add(curve_, QT_TRANSLATE_NOOP("Menus", "Use these &points in"));
}

void Menus::fillView(const Actions& actions) {
    QMenu* view = add(nullptr, QT_TRANSLATE_NOOP("Menus", "&View"));
    view->addActions({actions.editTool, actions.addTool});
    view->addSeparator();
    view->addActions({actions.zoomIn, actions.zoomOut, actions.zoomTo100, actions.fitAll, actions.fitSelection});
    view->addSeparator();
    view->addActions({actions.grid, actions.axes, actions.rulers, actions.snap});
    view->addSeparator();
    panels_ = add(view, QT_TRANSLATE_NOOP("Menus", "&Panels"));
    resetPanels_ = actions.resetPanels;
    view->addAction(actions.showHistory);
    view->addSeparator();
    view->addAction(actions.fullScreen);
}

void Menus::fillSettings() {
    QMenu* settings = add(nullptr, QT_TRANSLATE_NOOP("Menus", "&Settings"));
    QMenu* language = add(settings, QT_TRANSLATE_NOOP("Menus", "&Language"));
    auto* languages = new QActionGroup(this);
    for (const Language one : kLanguages) {
        QAction* action = language->addAction(languageName(one));
        action->setCheckable(true);
        languages->addAction(action);
        languages_.push_back(action);
        connect(action, &QAction::triggered, this, [this, one] { Q_EMIT languageChosen(one); });
    }
    QMenu* theme = add(settings, QT_TRANSLATE_NOOP("Menus", "&Theme"));
    auto* themes = new QActionGroup(this);
    // In the order of ThemeChoice.
    for (const char* text : {QT_TRANSLATE_NOOP("Menus", "&System"), QT_TRANSLATE_NOOP("Menus", "&Light"),
                             QT_TRANSLATE_NOOP("Menus", "&Dark")}) {
        QAction* action = theme->addAction(QString());
        action->setCheckable(true);
        themes->addAction(action);
        const auto choice = static_cast<ThemeChoice>(themes_.size());
        connect(action, &QAction::triggered, this, [this, choice] { Q_EMIT themeChosen(choice); });
        themes_.push_back({action, text, nullptr});
    }
}

void Menus::fillHelp(const Actions& actions) {
    QMenu* help = add(nullptr, QT_TRANSLATE_NOOP("Menus", "&Help"));
    help->addActions({actions.guide, actions.shortcuts});
    help->addSeparator();
    help->addActions({actions.about, actions.aboutQt});
}

void Menus::fillExamples(QMenu* file) {
    QMenu* menu = add(file, QT_TRANSLATE_NOOP("Menus", "Exa&mples"));
    menu->setToolTipsVisible(true);
    for (const Example& example : examples()) {
        QAction* action = menu->addAction(QString());
        const QString resource = QString::fromLatin1(example.resource);
        connect(action, &QAction::triggered, this, [this, resource] { Q_EMIT exampleChosen(resource); });
        examples_.push_back({action, example.name, example.lookAt});
    }
}

void Menus::setRecentFiles(const QStringList& paths) {
    recent_->clear();
    for (const QString& path : paths) {
        const QString name = printable(QFileInfo(path).fileName());
        const QString shown = recent_->fontMetrics().elidedText(name, Qt::ElideMiddle, kNameWidth);
        QAction* action = recent_->addAction(actionTextOf(shown));
        action->setToolTip(toolTipOf(path));
        connect(action, &QAction::triggered, this, [this, path] { Q_EMIT recentFileChosen(path); });
    }
    recent_->setToolTipsVisible(true);
    recent_->setEnabled(!paths.isEmpty());
}

void Menus::setLanguage(Language language) {
    languages_[static_cast<std::size_t>(language)]->setChecked(true);
}

void Menus::setThemeChoice(ThemeChoice choice) {
    themes_[static_cast<std::size_t>(choice)].action->setChecked(true);
}

void Menus::setSheetActions(const QList<QAction*>& actions) {
    for (QAction* action : sheetActions_)
        curve_->removeAction(action);
    sheetActions_ = actions;
    curve_->addActions(actions);
}

void Menus::setPanels(const QList<QAction*>& panels) {
    panels_->clear();
    panels_->addActions(panels);
    panels_->addSeparator();
    panels_->addAction(resetPanels_);
}

void Menus::setOtherSheets(const std::vector<std::pair<SheetIndex, QString>>& sheets) {
    otherSheets_->clear();
    for (const auto& [sheet, name] : sheets) {
        QAction* action = otherSheets_->addAction(name);
        connect(action, &QAction::triggered, this, [this, sheet = sheet] { Q_EMIT otherSheetChosen(sheet); });
    }
}

void Menus::retranslateUi() {
    for (const Title& title : titles_)
        title.menu->setTitle(QCoreApplication::translate("Menus", title.text));
    for (const auto& choices : {themes_, examples_})
        for (const Choice& choice : choices)
            choice.action->setText(QCoreApplication::translate("Menus", choice.text));
    for (const Choice& example : examples_)
        example.action->setToolTip(QCoreApplication::translate("Examples", example.toolTip));
    tools_.setWindowTitle(QCoreApplication::translate("Menus", "Tool bar"));
}

} // namespace kriva::ui
