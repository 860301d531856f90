#pragma once

#include "app/commands/command_line.h"
#include "app/commands/terminal.h"

namespace kriva::app {

/// Writes a document with the curves of all files in one sheet; `-` is the standard input and output. Nothing is
/// written where one of the files is refused.
[[nodiscard]] ExitCode importFiles(const ImportRequest& request);

} // namespace kriva::app
