#include "app/editor.h"

#include "app/end_signals.h"
#include "app/kept_memory.h"
#include "app/sheet_catalog.h"
#include "ui/base/examples.h"
#include "ui/base/look/desktop_scheme.h"
#include "ui/base/look/theme.h"
#include "ui/base/preferences.h"
#include "ui/document/state_folder.h"
#include "ui/window/dialogs/recovery_dialog.h"
#include "ui/window/document_session.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QSessionManager>

#include <unistd.h>

namespace kriva {
namespace {

/// Of the two seconds that the system gives.
constexpr std::chrono::milliseconds kMostForWriting{1'600};

/// All windows and what they share.
class Editor : public QObject {
  public:
    explicit Editor(const EditorStart& start)
        : files_(start.recovery)
        , language_(start.language.value_or(preferences_.language().value_or(ui::systemLanguage())))
        , theme_(preferences_.theme(), desktop_) {
        connect(&ends_, &EndSignals::received, this, [this] { ::_exit(keepAll() ? 0 : 1); });
        connect(
            qApp, &QGuiApplication::commitDataRequest, this, [this] { keepAll(); }, Qt::DirectConnection);
        connect(qApp, &QGuiApplication::saveStateRequest, this, &Editor::describe, Qt::DirectConnection);
    }

    void openWindows(const QStringList& files) {
        // Neither the end of the question nor that of a window without a document ends the program.
        QApplication::setQuitOnLastWindowClosed(false);
        const bool hasRecovered = recoverAll();
        for (const QString& file : files)
            open(file);
        if (files.isEmpty() && !hasRecovered)
            open({});
        QApplication::setQuitOnLastWindowClosed(true);
    }

  private:
    [[nodiscard]] ui::MainWindow* makeWindow() {
        auto* window = new ui::MainWindow({preferences_, language_, theme_, files_, sheets_});
        window->setAttribute(Qt::WA_DeleteOnClose);
        connect(window, &ui::MainWindow::newWindowAsked, this, [this] { open({}); });
        window->session().show(ui::startDocument()); // laid out once, before it is seen
        return window;
    }

    void open(const QString& file) {
        if (!file.isEmpty() && files_.open.bringUp(file))
            return;
        ui::MainWindow* window = makeWindow();
        window->show();
        if (!file.isEmpty())
            window->session().openFile(file);
    }

    /// Asks what is to become of unsaved work that was left; whether there is a window now.
    bool recoverAll() {
        const auto folder = ui::privateFolder(QStringLiteral("recovery"));
        const QString* path = std::get_if<QString>(&folder);
        std::vector<ui::FoundRecovery> found;
        if (path)
            found = ui::takeRecoveries(*path);
        if (found.empty())
            return false;
        ui::RecoveryDialog dialog(found);
        dialog.exec();
        const std::vector<ui::RecoveryChoice> choices = dialog.choices();
        bool hasRecovered = false;
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (choices[i] == ui::RecoveryChoice::Discard)
                ui::discardRecovery(std::move(found[i]));
            else if (choices[i] == ui::RecoveryChoice::Recover)
                hasRecovered = recover(std::move(found[i])) || hasRecovered;
        }
        return hasRecovered;
    }

    bool recover(ui::FoundRecovery found) {
        ui::MainWindow* window = makeWindow();
        window->show();
        const bool isDone = window->session().recover(std::move(found));
        if (!isDone)
            window->close();
        return isDone;
    }

    /// Whether all unsaved work is on the disk.
    bool keepAll() {
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (auto* window = qobject_cast<ui::MainWindow*>(widget))
                window->session().keepForNextStart();
        return files_.recovery.finishWithin(kMostForWriting) && files_.recovery.isAllWritten();
    }

    /// How the session manager starts this again: what was unsaved is offered then.
    static void describe(QSessionManager& manager) {
        manager.setRestartHint(QSessionManager::RestartIfRunning);
        manager.setRestartCommand({QCoreApplication::applicationFilePath()});
    }

    ui::Preferences preferences_;
    ui::SharedFiles files_;
    ui::LanguageSwitch language_;
    const ui::DesktopScheme desktop_;
    ui::ThemeSwitch theme_;
    const std::array<ui::SheetUi, kSheetCount> sheets_ = sheetCatalog();
    EndSignals ends_;
};

} // namespace

int runEditor(const EditorStart& start) {
    keepFreedMemory();
    Editor editor(start);
    editor.openWindows(start.files);
    return QApplication::exec();
}

} // namespace kriva
