#include "ui/window/shortcut_sheet.h"

#include "ui/window/dialogs/gesture_table.h"
#include "ui/window/main_window.h"

#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>

namespace kriva::ui {
namespace {

/// The text of a menu without its mnemonic, and without the step that Undo and Redo name.
[[nodiscard]] QString plain(QString text) {
    for (qsizetype at = 0; (at = text.indexOf(QLatin1Char('&'), at)) >= 0; ++at)
        text.remove(at, 1);
    return text.section(QLatin1Char(':'), 0, 0);
}

[[nodiscard]] QString keysOf(const QAction& action) {
    return QKeySequence::listToString(action.shortcuts(), QKeySequence::NativeText);
}

/// Those of the actions that have a shortcut, menus below included.
void add(ShortcutGroup& group, const QList<QAction*>& actions, const QList<QAction*>& leftOut = {}) {
    for (const QAction* action : actions) {
        if (action->menu())
            add(group, action->menu()->actions(), leftOut);
        else if (!action->shortcuts().isEmpty() && !leftOut.contains(action))
            group.rows.push_back({plain(action->text()), keysOf(*action)});
    }
}

[[nodiscard]] QString keysOf(const Gesture& gesture) {
    if (!gesture.keys)
        return gesture.sequence.toString(QKeySequence::NativeText);
    const QString keys = QCoreApplication::translate("Gestures", gesture.keys);
    return gesture.number > 0 ? keys.arg(gesture.number) : keys;
}

void addGestures(std::vector<ShortcutGroup>& sheet) {
    for (const GestureGroup& gestures : gestureTable()) {
        ShortcutGroup& group = sheet.emplace_back();
        group.title = QCoreApplication::translate("Gestures", gestures.title);
        for (const Gesture& gesture : gestures.gestures)
            group.rows.push_back({QCoreApplication::translate("Gestures", gesture.what), keysOf(gesture)});
    }
}

} // namespace

std::vector<ShortcutGroup> shortcutSheet(MainWindow& window) {
    // The menu Curve has those of the shown tab; here each tab's own stand under its name.
    QList<QAction*> ofTabs;
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        ofTabs += window.tab(sheet).actions().all();
    std::vector<ShortcutGroup> sheet;
    const auto addGroup = [&](const QString& title, const QList<QAction*>& actions, const QList<QAction*>& leftOut) {
        ShortcutGroup group{title, {}};
        add(group, actions, leftOut);
        if (!group.rows.empty())
            sheet.push_back(std::move(group));
    };
    for (const QAction* menu : window.menuBar()->actions())
        addGroup(plain(menu->text()), menu->menu()->actions(), ofTabs);
    for (SheetIndex index = 0; index < kSheetCount; ++index)
        addGroup(window.sheetTitle(index), window.tab(index).actions().all(), {});
    addGestures(sheet);
    return sheet;
}

} // namespace kriva::ui
