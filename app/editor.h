#pragma once

#include "ui/shell/language/language.h"

#include <QStringList>

#include <optional>

class QApplication;

namespace kriva {

/// Opens the editor, one window for each file, or one on the example that a new window begins with, in the language
/// asked for, else the one chosen last, else the system's; returns the exit code when the last window is closed.
[[nodiscard]] int runEditor(QApplication& application, const QStringList& files, std::optional<ui::Language> asked);

} // namespace kriva
