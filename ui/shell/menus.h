#pragma once

#include "ui/shell/language/language.h"
#include "ui/shell/look/theme.h"

#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

namespace kriva::ui {

class Actions;

/// The menu bar and the tool bar. What is chosen in a menu that is filled at run time is told by signals.
class Menus : public QObject {
    Q_OBJECT
  public:
    Menus(QMenuBar& bar, QToolBar& tools, const Actions& actions);

    void setRecentFiles(const QStringList& paths);
    void setLanguage(Language language);
    void setThemeChoice(ThemeChoice choice);
    /// What only the shown tab can do.
    void setSheetActions(const QList<QAction*>& actions);
    /// The panels of the shown tab.
    void setPanels(const QList<QAction*>& panels);
    void retranslateUi();

  Q_SIGNALS:
    void recentFileChosen(const QString& path);
    void exampleChosen(const QString& resource);
    void languageChosen(kriva::ui::Language language);
    void themeChosen(kriva::ui::ThemeChoice choice);

  private:
    struct Title {
        QMenu* menu;
        const char* text; ///< marked with QT_TRANSLATE_NOOP("Menus", ...)
    };
    struct Choice {
        QAction* action;
        const char* text;
    };
    QMenu* add(QMenu* parent, const char* text);
    void fillFile(const Actions& actions);
    void fillEdit(const Actions& actions);
    void fillCurve(const Actions& actions);
    void fillView(const Actions& actions);
    void fillSettings();
    void fillHelp(const Actions& actions);
    void fillExamples(QMenu* file);

    QMenuBar& bar_;
    QToolBar& tools_;
    std::vector<Title> titles_;
    std::vector<Choice> themes_;
    std::vector<Choice> examples_;
    std::vector<QAction*> languages_;
    QMenu* recent_ = nullptr;
    QMenu* curve_ = nullptr;
    QList<QAction*> sheetActions_;
    QMenu* panels_ = nullptr;
    QAction* resetPanels_ = nullptr;
};

} // namespace kriva::ui
