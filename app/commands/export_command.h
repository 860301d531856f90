#pragma once

#include "app/commands/command_line.h"
#include "app/commands/terminal.h"

namespace kriva::app {

/// Draws a sheet of each document into a file. Pictures need a QGuiApplication, of any platform. The worst code of all
/// files.
[[nodiscard]] ExitCode exportFigures(const ExportRequest& request);

} // namespace kriva::app
