#pragma once

#include "app/sheet_catalog.h"
#include "tests/support/sheet_curves.h"
#include "ui/base/examples.h"
#include "ui/base/language/language.h"
#include "ui/base/look/desktop_scheme.h"
#include "ui/base/look/theme.h"
#include "ui/base/preferences.h"
#include "ui/window/document_session.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QDockWidget>
#include <QTest>

namespace kriva::test {

/// Lets everything arrive that was asked for: what takes long comes from other threads, and is shown a turn later.
inline void settle() {
    for (int turn = 0; turn < 3; ++turn) {
        QApplication::processEvents();
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (auto* window = qobject_cast<ui::MainWindow*>(widget))
                window->workers().waitForDone();
    }
    QApplication::processEvents();
}

/// The real window with all that it stands on, shown offscreen on the example of a new window.
struct TestWindow {
    explicit TestWindow(ui::Language spoken = ui::Language::English)
        : language(spoken) {
        window.resize(1280, 800);
        window.show();
        window.session().show(ui::startDocument());
        QApplication::processEvents();
    }

    /// The tab of a sheet, brought to the front.
    ui::SheetTab& shown(SheetIndex sheet) {
        window.document().setActiveSheet(sheet);
        QApplication::processEvents();
        ui::SheetTab& tab = window.tab(sheet);
        tab.canvas().setFocus();
        tab.canvas().fitAll();
        QApplication::processEvents();
        return tab;
    }
    [[nodiscard]] int steps(SheetIndex sheet) { return window.document().history(sheet).count(); }

    ui::Preferences preferences;
    ui::LanguageSwitch language;
    ui::DesktopScheme desktop;
    ui::ThemeSwitch theme{ui::ThemeChoice::Light, desktop};
    ui::SharedFiles files;
    std::array<ui::SheetUi, kSheetCount> sheets = sheetCatalog();
    ui::MainWindow window{{preferences, language, theme, files, sheets}};
};

/// Brings every panel of a tab to the front once: only then it is made.
inline void seeAllPanels(ui::SheetTab& tab) {
    for (QDockWidget* dock : tab.findChildren<QDockWidget*>()) {
        dock->raise();
        settle();
    }
}

/// Where a point of the active curve is on the canvas.
inline QPoint pixelOf(ui::SheetTab& tab, int point) {
    return tab.canvas().mapping().toPixels(pointAt(*tab.editor().activeCurve(), point)).toPoint();
}

} // namespace kriva::test
