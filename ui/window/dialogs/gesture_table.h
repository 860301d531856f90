#pragma once

#include <QKeySequence>

#include <vector>

namespace kriva::ui {

/// Something that is done with the mouse or with a key that is no shortcut of a menu.
struct Gesture {
    const char* what;           ///< marked with QT_TRANSLATE_NOOP("Gestures", ...)
    const char* keys = nullptr; ///< marked so too; null where it is a key alone
    QKeySequence sequence = {}; ///< then this one
    int number = 0;             ///< in place of %1 in the keys
};

struct GestureGroup {
    const char* title; ///< marked with QT_TRANSLATE_NOOP("Gestures", ...)
    std::vector<Gesture> gestures;
};

/// What ui/canvas and the player do, for people to read.
[[nodiscard]] std::vector<GestureGroup> gestureTable();

} // namespace kriva::ui
