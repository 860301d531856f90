#pragma once

#include "app/commands/command_line.h"
#include "app/commands/terminal.h"
#include "core/curve/file_error.h"

namespace kriva::app {

/// Prints the numbers of a document, as JSON or as a table in the present language. Needs no display.
[[nodiscard]] ExitCode report(const ReportRequest& request);

/// The table of a document, or of one of its sheets; sheets without curves are left out. Refused where the JSON is.
[[nodiscard]] std::variant<QString, FileError> reportTable(const Document& document, std::optional<SheetIndex> only);

} // namespace kriva::app
