#pragma once

#include <QStringList>

class QApplication;

namespace kriva {

/// Opens the editor, one window for each file, or one on the example that a new window begins with; returns the exit
/// code when the last window is closed.
[[nodiscard]] int runEditor(QApplication& application, const QStringList& files);

} // namespace kriva
