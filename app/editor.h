#pragma once

#include "ui/base/language/language.h"
#include "ui/document/recovery/recovery_writer.h"

#include <QStringList>

#include <optional>

namespace kriva {

/// What the editor begins with.
struct EditorStart {
    QStringList files = {};                    ///< a window for each; none: one with an example
    std::optional<ui::Language> language = {}; ///< else the one chosen last, else the system's
    ui::RecoveryTiming recovery = {};
};

/// Offers what could not be saved the last time, then opens the windows; returns the exit code when the last one is
/// closed. There is a QApplication. Ended by a signal, the program keeps unsaved work for the next start, asks nothing
/// and does not come back from here: exit code 0 where all is kept, 1 where something is not.
[[nodiscard]] int runEditor(const EditorStart& start);

} // namespace kriva
