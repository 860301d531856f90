#include "app/editor.h"

#include "app/sheet_catalog.h"
#include "ui/shell/document_session.h"
#include "ui/shell/examples.h"
#include "ui/shell/language/language.h"
#include "ui/shell/look/desktop_scheme.h"
#include "ui/shell/look/theme.h"
#include "ui/shell/main_window.h"
#include "ui/shell/preferences.h"

#include <QApplication>

#include <functional>

namespace kriva {

int runEditor(QApplication& application, const QStringList& files, std::optional<ui::Language> asked) {
    ui::Preferences preferences;
    if (!asked)
        asked = preferences.language();
    ui::LanguageSwitch language(asked.value_or(ui::systemLanguage()));
    const ui::DesktopScheme desktop;
    ui::ThemeSwitch theme(preferences.theme(), desktop);
    const auto sheets = sheetCatalog();
    const ui::MainWindow::Surroundings surroundings{preferences, language, theme, sheets};
    const std::function<void(const QString&)> open = [&](const QString& file) {
        auto* window = new ui::MainWindow(surroundings);
        window->setAttribute(Qt::WA_DeleteOnClose);
        QObject::connect(window, &ui::MainWindow::newWindowAsked, window, [&open] { open({}); });
        window->session().show(ui::startDocument()); // laid out once, before it is seen
        window->show();
        if (!file.isEmpty())
            window->session().openFile(file);
    };
    for (const QString& file : files)
        open(file);
    if (files.isEmpty())
        open({});
    return application.exec();
}

} // namespace kriva
