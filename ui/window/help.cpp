#include "ui/window/help.h"

#include "ui/base/examples.h"
#include "ui/window/actions/actions.h"
#include "ui/window/dialogs/about_dialog.h"
#include "ui/window/document_session.h"
#include "ui/window/main_window.h"
#include "ui/window/shortcut_sheet.h"
#include "ui/window/shortcuts_dialog.h"

#include <QApplication>

namespace kriva::ui {

Help::Help(MainWindow& window, const Actions& actions)
    : QObject(&window)
    , window_(window) {
    connect(actions.guide, &QAction::triggered, this, [this] { window_.currentTab().panels().showGuide(); });
    connect(actions.shortcuts, &QAction::triggered, this, &Help::showShortcuts);
    connect(actions.about, &QAction::triggered, this, &Help::showAbout);
    connect(actions.aboutQt, &QAction::triggered, qApp, &QApplication::aboutQt);
    connect(&window.document(), &OpenDocument::replaced, this, &Help::leaveExample);
    connect(&window.session(), &DocumentSession::exampleOpened, this, &Help::showExample);
}

void Help::showShortcuts() {
    auto* dialog = window_.findChild<ShortcutsDialog*>();
    if (!dialog) {
        dialog = new ShortcutsDialog([this] { return shortcutSheet(window_); }, &window_);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

void Help::showAbout() {
    auto* dialog = new AboutDialog(&window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
}

void Help::showExample(const QString& resource) {
    const Example* example = exampleOf(resource);
    if (!example)
        return;
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        window_.tab(sheet).panels().setExample(example);
    Q_EMIT told(QCoreApplication::translate("Examples", example->lookAt));
}

void Help::leaveExample() {
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        window_.tab(sheet).panels().setExample(nullptr);
}

} // namespace kriva::ui
