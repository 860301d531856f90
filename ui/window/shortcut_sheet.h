#pragma once

#include <QString>

#include <vector>

namespace kriva::ui {

class MainWindow;

/// Shortcuts that belong together, in the present language.
struct ShortcutGroup {
    struct Row {
        QString what;
        QString keys;
    };
    QString title;
    std::vector<Row> rows;
};

/// All that can be done with keys and mouse: the actions of the menus and of every tab that have a shortcut, then what
/// the canvas and the player know by themselves.
[[nodiscard]] std::vector<ShortcutGroup> shortcutSheet(MainWindow& window);

} // namespace kriva::ui
