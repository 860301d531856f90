#pragma once

#include "app/commands/command_line.h"
#include "app/commands/terminal.h"

namespace kriva::app {

/// Draws a sheet of a document into a file. Needs no display.
[[nodiscard]] ExitCode exportFigure(const ExportRequest& request);

} // namespace kriva::app
