#pragma once

#include "ui/tabs/sheet_tab.h"

#include <QTabWidget>
#include <QThreadPool>

namespace kriva::ui {

class Actions;
class DocumentSession;
class LanguageSwitch;
class Menus;
class Preferences;
class StatusRow;
class ThemeSwitch;
struct SharedFiles;

/// A window: one document, one tab for each sheet, menus and status bar.
class MainWindow : public QMainWindow {
    Q_OBJECT
  public:
    /// What outlives the window and is shared by all of them.
    struct Surroundings {
        Preferences& preferences;
        LanguageSwitch& language;
        ThemeSwitch& theme;
        SharedFiles& files;
        std::span<const SheetUi> sheets; ///< in the order of the document's
    };
    explicit MainWindow(const Surroundings& surroundings);
    ~MainWindow() override;

    /// Where what takes long is worked out, beside the hand.
    [[nodiscard]] QThreadPool& workers() { return workers_; }
    [[nodiscard]] OpenDocument& document() { return document_; }
    [[nodiscard]] DocumentSession& session() { return *session_; }
    [[nodiscard]] SheetTab& tab(SheetIndex sheet) { return *tabs_[sheet]; }
    /// In the present language.
    [[nodiscard]] QString sheetTitle(SheetIndex sheet) const;
    [[nodiscard]] SheetTab& currentTab() { return *tabs_[document_.value().active]; }
    void setVisible(bool isVisible) override;

  Q_SIGNALS:
    /// A further window is wanted; who makes windows makes it.
    void newWindowAsked();

  protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

  private:
    void makeTabs(std::span<const SheetUi> sheets);
    void connectActions();
    void connectEditActions();
    void connectViewActions();
    void retranslateUi();
    void showTitle();
    void followTab();
    void followHistory();
    void followSelection();
    void showTheme();

    Surroundings surroundings_;
    QThreadPool workers_;
    OpenDocument document_;
    Actions* actions_;
    DocumentSession* session_;
    Menus* menus_;
    StatusRow* status_;
    QTabWidget* tabWidget_;
    std::vector<SheetTab*> tabs_;
};

} // namespace kriva::ui
