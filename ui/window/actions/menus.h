#pragma once

#include "core/document/document.h"
#include "ui/base/language/language.h"
#include "ui/base/look/theme.h"

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
    /// The other tabs, to which the points of a curve can go.
    void setOtherSheets(const std::vector<std::pair<SheetIndex, QString>>& sheets);
    /// Whether there is a curve whose points could go there.
    void setHasCurve(bool hasCurve) { otherSheets_->setEnabled(hasCurve); }
    void retranslateUi();

  Q_SIGNALS:
    void otherSheetChosen(kriva::SheetIndex sheet);
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
        const char* toolTip = nullptr; ///< marked with QT_TRANSLATE_NOOP("Examples", ...)
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
    QMenu* otherSheets_ = nullptr;
    QAction* resetPanels_ = nullptr;
};

} // namespace kriva::ui
